// SPDX-License-Identifier: MIT
// The structs of flinch.h, in its order, with what makes them.
using System;
using System.Runtime.InteropServices;

namespace FlinchGame {

/// <summary>What a call tells. Errors are exceptions.</summary>
public enum Answer { Ok = 0, Misses = 1, Unnoticed = 2, OutsideTraining = 3, NoGoodAnswer = 4 }

public enum Target { Head = 0, Trunk = 1, Pelvis = 2, Legs = 3 }

public enum Phase {
  Idle = 0, Reacting = 1, Waiting = 2, Shifting = 3, Blending = 4, Protecting = 5, Returning = 6,
  Pushed = 7, Walking = 8
}

public enum ReactionPhase {
  None = 0, Awaits = 1, Struck = 2, Recovers = 3, Returns = 4, Over = 5, KnockedOver = 6
}

public enum Shape { Ball = 0, Blade = 1, Fist = 2, Rod = 3 }

public enum MovedBy { Character = 0, Physics = 1, Clip = 2 }

/// <summary>Something that approaches, as it is now. Make it by Threat.Ball or set every field.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Threat {
  public uint Size;
  public fixed float Position[3];
  public fixed float Velocity[3];
  public float Radius, Mass_kg;
  public int Kind;
  public float StartsIn_s, Lasts_s;
  // Of a rod only: from butt to tip, unit; its turning; from Position to its ends.
  public fixed float Axis[3];
  public fixed float AngularVelocity[3];
  public float ToButt_m, ToTip_m;

  public static Threat Ball(float x, float y, float z, float vx, float vy, float vz,
                            float radius = 0.105F, float mass_kg = 0.27F) {
    var threat = new Threat { Size = (uint)sizeof(Threat), Radius = radius, Mass_kg = mass_kg };
    threat.Position[0] = x;
    threat.Position[1] = y;
    threat.Position[2] = z;
    threat.Velocity[0] = vx;
    threat.Velocity[1] = vy;
    threat.Velocity[2] = vz;
    return threat;
  }
}

/// <summary>All that moves: the pelvis' position, world, m, and 21 local rotations.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Pose {
  public const int Joints = 21;
  public uint Size;
  public fixed float RootPosition[3];
  public fixed float Rotation[4 * Joints];

  public static Pose Make() { return new Pose { Size = (uint)sizeof(Pose) }; }
}

/// <summary>Position and orientation of every joint, world.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct JointFrames {
  public uint Size;
  public fixed float Position[3 * Pose.Joints];
  public fixed float Orientation[4 * Pose.Joints];

  public static JointFrames Make() { return new JointFrames { Size = (uint)sizeof(JointFrames) }; }
}

/// <summary>How much of each joint's motion comes from Flinch and how much from the game.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Mask {
  public uint Size;
  public float Weight;
  public fixed float Joint[Pose.Joints];

  public static Mask Make() { return new Mask { Size = (uint)sizeof(Mask), Weight = 1 }; }
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct CharacterState {
  public uint Size;
  public Phase Phase;
  public int Clip;  // that answers, or the idle clip; -1: by rule
  public Target Target;
  public float TimeToImpact_s;
  public fixed float Position[2];
  public float Facing;
}

[StructLayout(LayoutKind.Sequential)]
public unsafe struct PerceptionLimits {
  public uint Size;
  public float ReactionDelay_s, BearingNoise, DistanceNoise, HeadingNoise, SpeedNoise, ChanceToFail;

  public static PerceptionLimits Human(int choices) {
    var limits = new PerceptionLimits { Size = (uint)sizeof(PerceptionLimits) };
    Native.Check(Native.flinch_human_limits(choices, ref limits));
    return limits;
  }
}

/// <summary>A clip that the selector considered.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Candidate {
  public int Clip;
  public float Vote, ExpectedCost_ns;
}

/// <summary>A response that could answer a push.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct PushCandidate {
  public int Clip;
  public float Realism, Turn, Taper;
  public fixed float Deformation[3];
}

/// <summary>A number of a threat that is outside of the range of training; Name is valid as long as
/// the library.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Outside {
  private IntPtr name;
  public float Value, TrainedFrom, TrainedTo;
  private int reserved;

  public string Name { get { return Native.Text(name); } }
}

/// <summary>A threat that a character has noticed: what an answer is planned for.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Perception {
  public uint Size;
  public Target Target;
  public float TimeToImpact_s, Delay_s;
  public fixed float Position[2];
  public float Facing, StanceTime_s;
  public int Stance;
  public Threat Threat;

  public static Perception Make() {
    var made = new Perception { Size = (uint)sizeof(Perception) };
    made.Threat.Size = (uint)sizeof(Threat);
    return made;
  }
}

/// <summary>When a response would do what, s after the reaction delay.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Plan {
  public uint Size;
  public float FirstMotion_s, Begin_s, Peak_s, End_s, Duration_s;
  public float PlaybackRate;  // seconds of the clip per second
}

public enum ForeseenHow { Nothing = 0, Costlier = 1, Misses = 2, Simulated = 3, Cut = 4 }

/// <summary>A candidate of looking ahead; not a number where nothing is known.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Foreseen {
  public int Clip;
  public ForeseenHow How;
  public float Work_j, Damage_ns, Cost_ns;
  public float Contact_s;  // after perception; infinite if nothing touches
}

/// <summary>The result of looking ahead.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct LookAheadStatus {
  public const int MostCandidates = 16;
  public uint Size;
  public int CandidateCount, Tried, Encounters;
  public int Chosen;  // of the candidates
  public int Threats, Ignored, IsComplete;
  private fixed int candidates[6 * MostCandidates];

  /// <summary>Candidate number `index`, from 0 to CandidateCount - 1.</summary>
  public Foreseen Candidate(int index) {
    if (index < 0 || index >= CandidateCount) throw new ArgumentOutOfRangeException("index");
    fixed (int* all = candidates) return ((Foreseen*)all)[index];
  }
}

/// <summary>How a character takes a hit.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct ReactionOptions {
  public uint Size;
  public float SimulationOnly_s;  // for which physics alone moves it after the contact
  public float Stiffness;         // of the joints, as a share of that in training

  public static ReactionOptions Make() {
    var made = new ReactionOptions { Size = (uint)sizeof(ReactionOptions) };
    Native.Check(Native.flinch_reaction_defaults(ref made));
    return made;
  }
}

/// <summary>The last reaction of a character.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Reaction {
  public uint Size;
  public ReactionPhase Phase;
  public MovedBy MovedBy;
  public int Clip;
  public float Contact_s;
  public fixed float BallPosition[3];
  public fixed float BallVelocity[3];
  public fixed float Impulse_ns[17];
  public fixed float BallAxis[3];  // of a rod, from butt to tip; 0 for a ball
  public fixed float BallMomentum[3];  // that it has passed to the figure, N s
}

[StructLayout(LayoutKind.Sequential)]
public struct LibraryInfo {
  public uint Size;
  public int ClipCount, IdleClip;
  public float Rate_hz, Mass_kg;
  public int KindCount;
}

/// <summary>A clip of a library; Name and Kind are valid as long as that is.</summary>
[StructLayout(LayoutKind.Sequential)]
public struct Clip {
  public uint Size;
  public int IsAnnotated;
  private IntPtr name, kind;
  public float Duration_s;
  public Target Target;
  public float Direction;
  public int Degree;
  public float Onset_s, Peak_s, End_s;
  private int reserved;

  public string Name { get { return Native.Text(name); } }
  public string Kind { get { return Native.Text(kind); } }
}

/// <summary>Bone lengths: the rest pose, in which it faces +X.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Skeleton {
  public uint Size;
  public fixed float Offset[3 * Pose.Joints];  // from the parent's joint, m
  public fixed float Tip[3 * Pose.Joints];     // from the joint to the end of its segment, m
}

/// <summary>The shape and mass of a body, in the frame of the joint that moves it.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct Outline {
  public const int Bodies = 17;
  public uint Size;
  public int Joint, IsBox;  // 0: a capsule along Z
  public fixed float Centre[3];
  public fixed float Orientation[4];
  public float Radius, HalfLength;
  public fixed float HalfExtents[3];
  public float Mass_kg;
  public fixed float CentreOfMass[3];
}

/// <summary>A kind of threat: the smallest and the largest of each number. Name is valid as long as
/// the library.</summary>
[StructLayout(LayoutKind.Sequential)]
public unsafe struct ThreatKind {
  public uint Size;
  public Shape Shape;
  private IntPtr name;
  public fixed float Radius[2];
  public fixed float Mass_kg[2];
  public fixed float Speed_mps[2];
  public fixed float Elevation[2];
  public fixed float TimeToImpact_s[2];
  public fixed float Reach_m[2];
  public float Restitution, Friction;
  public int IsStraight;
  private int reserved;
  public fixed float Length_m[2];

  public string Name { get { return Native.Text(name); } }
}

}
