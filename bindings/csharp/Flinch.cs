// SPDX-License-Identifier: MIT
// Flinch in C#: docs/csharp.md. One file for Mono, .NET and Unity, over the C interface; compile it
// with /unsafe. Names, units and frames are those of flinch.h: SI units, radians, Z up, quaternions
// w, x, y, z. What is made is freed by Dispose() or by the garbage collector.
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace FlinchGame {

/// <summary>An error that Flinch reports, with its text and its status in flinch.h.</summary>
public sealed class FlinchException : Exception {
  public readonly int Status;
  public FlinchException(int status) : base(Native.Text(Native.flinch_status_message(status))) {
    Status = status;
  }
}

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

/// <summary>What `flinch train` wrote. Immutable: any threads may use it.</summary>
public sealed class Library : IDisposable {
  internal readonly Handle Handle;

  public Library(string path) {
    IntPtr made;
    Native.Check(Native.flinch_library_load(Native.Bytes(path), out made));
    Handle = new Handle(made, Native.flinch_library_free);
  }
  public Library(byte[] file) {
    IntPtr made;
    Native.Check(Native.flinch_library_load_memory(file, (UIntPtr)file.Length, out made));
    Handle = new Handle(made, Native.flinch_library_free);
  }
  public void Dispose() { Handle.Dispose(); }

  public unsafe LibraryInfo Describe() {
    var info = new LibraryInfo { Size = (uint)sizeof(LibraryInfo) };
    Native.Check(Native.flinch_library_describe(Handle, ref info));
    return info;
  }
  public unsafe Clip Clip(int index) {
    var clip = new Clip { Size = (uint)sizeof(Clip) };
    Native.Check(Native.flinch_library_clip(Handle, index, ref clip));
    return clip;
  }
  public void ComputeJoints(ref Pose pose, ref JointFrames frames) {
    Native.Check(Native.flinch_library_joint_frames(Handle, ref pose, ref frames));
  }
  /// <summary>Writes the pose of a clip at a time of it, above the world's origin.</summary>
  public void GetClipPose(int clip, float time_s, ref Pose pose) {
    Native.Check(Native.flinch_library_clip_pose(Handle, clip, time_s, ref pose));
  }
  public static string JointName(int joint) { return Native.Text(Native.flinch_joint_name(joint)); }
  public static int JointParent(int joint) { return Native.flinch_joint_parent(joint); }
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

/// <summary>Memory for choosing clips: one for each thread that perceives.</summary>
public sealed class Workspace : IDisposable {
  internal readonly Handle Handle;

  public Workspace(Library library) {
    IntPtr made;
    Native.Check(Native.flinch_workspace_create(library.Handle, out made));
    Handle = new Handle(made, Native.flinch_workspace_free);
  }
  public void Dispose() { Handle.Dispose(); }
}

/// <summary>Memory for looking ahead: one for each thread that looks ahead.</summary>
public sealed class LookAhead : IDisposable {
  internal readonly Handle Handle;

  public LookAhead(Library library) {
    IntPtr made;
    Native.Check(Native.flinch_look_ahead_create(library.Handle, out made));
    Handle = new Handle(made, Native.flinch_look_ahead_free);
  }
  public void Dispose() { Handle.Dispose(); }
}

/// <summary>A character: it perceives, answers, can be hit if it was made so, and returns to idle.
/// One thread at a time may use it. Nothing but the constructor allocates.</summary>
public sealed unsafe class Character : IDisposable {
  private readonly Handle handle;

  public Character(Library library, bool reacting = false) {
    IntPtr made;
    Native.Check(reacting ? Native.flinch_character_create_reacting(library.Handle, out made)
                          : Native.flinch_character_create(library.Handle, out made));
    handle = new Handle(made, Native.flinch_character_free);
  }
  public void Dispose() { handle.Dispose(); }

  public void Place(float x, float y, float facing, float stanceTime_s = 0, int stance = 0) {
    Native.Check(Native.flinch_character_place_in_stance(handle, x, y, facing, stanceTime_s, stance));
  }
  public void ChangeStance(int stance) {
    Native.Check(Native.flinch_character_change_stance(handle, stance));
  }
  public void SetPose(ref Pose before, ref Pose now, float dt_s) {
    Native.Check(Native.flinch_character_set_pose(handle, ref before, ref now, dt_s));
  }
  public void Settle() { Native.Check(Native.flinch_character_settle(handle)); }
  public void LimitPerception(ref PerceptionLimits limits, ulong seed) {
    Native.Check(Native.flinch_character_limit_perception(handle, ref limits, seed));
  }

  public Answer Perceive(ref Threat threat, Workspace workspace) {
    return Native.Check(Native.flinch_character_perceive(handle, ref threat, workspace.Handle));
  }
  public Answer PerceiveAll(Threat[] threats, Workspace workspace) {
    return Native.Check(
        Native.flinch_character_perceive_all(handle, threats, threats.Length, workspace.Handle));
  }
  public Answer PerceiveKnown(ref Threat threat, Target target, float timeToImpact_s,
                              Workspace workspace) {
    return Native.Check(Native.flinch_character_perceive_known(handle, ref threat, target,
                                                               timeToImpact_s, workspace.Handle));
  }
  public Answer Brace(ref Threat threat, bool startles = false) {
    return Native.Check(Native.flinch_character_brace(handle, ref threat, startles ? 1 : 0));
  }
  public void Respond(int clip, float timeToImpact_s) {
    Native.Check(Native.flinch_character_respond(handle, clip, timeToImpact_s));
  }
  public Answer Push(int joint, float vx, float vy, float vz, Workspace workspace) {
    float* velocity = stackalloc float[3];
    velocity[0] = vx;
    velocity[1] = vy;
    velocity[2] = vz;
    return Native.Check(Native.flinch_character_push(handle, joint, velocity, workspace.Handle));
  }
  /// <summary>Writes the candidates of the last push, best first; returns their number.</summary>
  public int PushCandidates(PushCandidate[] candidates) {
    int count;
    Native.Check(Native.flinch_character_push_candidates(handle, candidates, candidates.Length,
                                                         out count));
    return count;
  }
  /// <summary>Simulates the selector's best clips and answers with the one that costs least.</summary>
  public Answer LookAhead(Threat[] threats, int candidates, LookAhead memory) {
    var options = new LookAheadOptions {
      Size = (uint)sizeof(LookAheadOptions), Candidates = candidates
    };
    return Native.Check(Native.flinch_character_look_ahead(handle, threats, threats.Length,
                                                           ref options, memory.Handle, IntPtr.Zero));
  }
  /// <summary>Hands the body to physics, because the ball is about to hit.</summary>
  public void ReactTo(ref Threat ball) {
    Native.Check(Native.flinch_character_react_to(handle, ref ball));
  }

  /// <summary>Ends physics at once: the body is where its own motion has it.</summary>
  public void StopReaction() { Native.Check(Native.flinch_character_stop_reaction(handle)); }
  /// <summary>Puts it into the state of another one of the library; neither takes hits.</summary>
  public void CopyFrom(Character saved) {
    Native.Check(Native.flinch_character_copy(handle, saved.handle));
  }

  public void Update(float dt_s) { Native.Check(Native.flinch_character_update(handle, dt_s)); }
  public void GetPose(ref Pose pose) { Native.Check(Native.flinch_character_pose(handle, ref pose)); }
  public void GetPoseOver(ref Pose game, ref Mask mask, ref Pose pose) {
    Native.Check(Native.flinch_character_pose_over(handle, ref game, ref mask, ref pose));
  }
  public CharacterState Describe() {
    var state = new CharacterState { Size = (uint)sizeof(CharacterState) };
    Native.Check(Native.flinch_character_describe(handle, ref state));
    return state;
  }
  public Reaction DescribeReaction() {
    var reaction = new Reaction { Size = (uint)sizeof(Reaction) };
    Native.Check(Native.flinch_character_reaction(handle, ref reaction));
    return reaction;
  }
  /// <summary>Writes what the selector considered, best first; returns their number.</summary>
  public int Candidates(Candidate[] candidates) {
    int count;
    Native.Check(Native.flinch_character_candidates(handle, candidates, candidates.Length, out count));
    return count;
  }
}

/// <summary>Flinch's axes (right-handed, Z up, X forward, Y left) in Unity's (left-handed, Y up, Z
/// forward) and back. Rotations may be local ones or the world's.</summary>
public static class UnityAxes {
  public static void Position(float x, float y, float z, out float ux, out float uy, out float uz) {
    ux = -y;
    uy = z;
    uz = x;
  }
  public static void PositionBack(float ux, float uy, float uz, out float x, out float y, out float z) {
    x = uz;
    y = -ux;
    z = uy;
  }
  /// <summary>From w, x, y, z to the arguments of UnityEngine.Quaternion in their order.</summary>
  public static void Rotation(float w, float x, float y, float z, out float ux, out float uy,
                              out float uz, out float uw) {
    ux = y;
    uy = -z;
    uz = -x;
    uw = w;
  }
  public static void RotationBack(float ux, float uy, float uz, float uw, out float w, out float x,
                                  out float y, out float z) {
    w = uw;
    x = -uz;
    y = ux;
    z = -uy;
  }
}

[StructLayout(LayoutKind.Sequential)]
internal struct LookAheadOptions {
  public uint Size;
  public int Candidates;
  public float Budget_us;
  private int reserved;
  private IntPtr now_us, clock;
}

/// A handle of the C interface, which the garbage collector frees if nobody else does.
internal sealed class Handle : SafeHandle {
  private readonly Func<IntPtr, int> free;

  internal Handle(IntPtr made, Func<IntPtr, int> freedBy) : base(IntPtr.Zero, true) {
    free = freedBy;
    SetHandle(made);
  }
  public override bool IsInvalid { get { return handle == IntPtr.Zero; } }
  protected override bool ReleaseHandle() { return free(handle) >= 0; }
}

internal static unsafe class Native {
  private const string Flinch = "flinch";  // libflinch.so, flinch.dll

  internal static Answer Check(int status) {
    if (status < 0) throw new FlinchException(status);
    return (Answer)status;
  }
  internal static string Text(IntPtr text) {
    if (text == IntPtr.Zero) return null;
    int length = 0;
    while (Marshal.ReadByte(text, length) != 0) ++length;
    var bytes = new byte[length];
    Marshal.Copy(text, bytes, 0, length);
    return Encoding.UTF8.GetString(bytes);
  }
  internal static byte[] Bytes(string text) { return Encoding.UTF8.GetBytes(text + "\0"); }

  [DllImport(Flinch)] internal static extern IntPtr flinch_status_message(int status);
  [DllImport(Flinch)] internal static extern IntPtr flinch_joint_name(int joint);
  [DllImport(Flinch)] internal static extern int flinch_joint_parent(int joint);
  [DllImport(Flinch)] internal static extern int flinch_library_load(byte[] path, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_library_load_memory(byte[] bytes, UIntPtr count, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_library_free(IntPtr library);
  [DllImport(Flinch)] internal static extern int flinch_library_describe(Handle library, ref LibraryInfo info);
  [DllImport(Flinch)] internal static extern int flinch_library_clip(Handle library, int index, ref Clip clip);
  [DllImport(Flinch)] internal static extern int flinch_library_joint_frames(Handle library, ref Pose pose, ref JointFrames frames);
  [DllImport(Flinch)] internal static extern int flinch_workspace_create(Handle library, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_workspace_free(IntPtr workspace);
  [DllImport(Flinch)] internal static extern int flinch_look_ahead_create(Handle library, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_look_ahead_free(IntPtr lookAhead);
  [DllImport(Flinch)] internal static extern int flinch_character_create(Handle library, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_character_create_reacting(Handle library, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_character_free(IntPtr character);
  [DllImport(Flinch)] internal static extern int flinch_character_place_in_stance(Handle character, float x, float y, float facing, float stanceTime_s, int stance);
  [DllImport(Flinch)] internal static extern int flinch_character_change_stance(Handle character, int stance);
  [DllImport(Flinch)] internal static extern int flinch_character_set_pose(Handle character, ref Pose before, ref Pose now, float dt_s);
  [DllImport(Flinch)] internal static extern int flinch_character_settle(Handle character);
  [DllImport(Flinch)] internal static extern int flinch_character_limit_perception(Handle character, ref PerceptionLimits limits, ulong seed);
  [DllImport(Flinch)] internal static extern int flinch_human_limits(int choices, ref PerceptionLimits limits);
  [DllImport(Flinch)] internal static extern int flinch_character_perceive(Handle character, ref Threat threat, Handle workspace);
  [DllImport(Flinch)] internal static extern int flinch_character_perceive_all(Handle character, [In] Threat[] threats, int count, Handle workspace);
  [DllImport(Flinch)] internal static extern int flinch_character_perceive_known(Handle character, ref Threat threat, Target target, float timeToImpact_s, Handle workspace);
  [DllImport(Flinch)] internal static extern int flinch_character_brace(Handle character, ref Threat threat, int startles);
  [DllImport(Flinch)] internal static extern int flinch_character_respond(Handle character, int clip, float timeToImpact_s);
  [DllImport(Flinch)] internal static extern int flinch_character_push(Handle character, int joint, float* velocity, Handle workspace);
  [DllImport(Flinch)] internal static extern int flinch_character_push_candidates(Handle character, [Out] PushCandidate[] candidates, int capacity, out int count);
  [DllImport(Flinch)] internal static extern int flinch_character_look_ahead(Handle character, [In] Threat[] threats, int count, ref LookAheadOptions options, Handle lookAhead, IntPtr status);
  [DllImport(Flinch)] internal static extern int flinch_character_react_to(Handle character, ref Threat ball);
  [DllImport(Flinch)] internal static extern int flinch_character_stop_reaction(Handle character);
  [DllImport(Flinch)] internal static extern int flinch_character_copy(Handle character, Handle saved);
  [DllImport(Flinch)] internal static extern int flinch_library_clip_pose(Handle library, int clip, float time_s, ref Pose pose);
  [DllImport(Flinch)] internal static extern int flinch_character_update(Handle character, float dt_s);
  [DllImport(Flinch)] internal static extern int flinch_character_pose(Handle character, ref Pose pose);
  [DllImport(Flinch)] internal static extern int flinch_character_pose_over(Handle character, ref Pose game, ref Mask mask, ref Pose pose);
  [DllImport(Flinch)] internal static extern int flinch_character_describe(Handle character, ref CharacterState state);
  [DllImport(Flinch)] internal static extern int flinch_character_candidates(Handle character, [Out] Candidate[] candidates, int capacity, out int count);
  [DllImport(Flinch)] internal static extern int flinch_character_reaction(Handle character, ref Reaction reaction);
}

}
