// SPDX-License-Identifier: MIT
// Flinch in C#: docs/csharp.md. For Mono, .NET and Unity, over the C interface; compile the files of
// this folder with /unsafe. Names, units and frames are those of flinch.h: SI units, radians, Z up,
// quaternions w, x, y, z. What is made is freed by Dispose() or by the garbage collector.
using System;

namespace FlinchGame {

/// <summary>An error that Flinch reports, with its text and its status in flinch.h.</summary>
public sealed class FlinchException : Exception {
  public readonly int Status;
  public FlinchException(int status) : base(Native.Text(Native.flinch_status_message(status))) {
    Status = status;
  }
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
  /// <summary>Loads a selector's file for the clips of another library, which both share.</summary>
  public Library(byte[] file, Library owner) {
    IntPtr made;
    Native.Check(Native.flinch_library_load_beside(file, (UIntPtr)file.Length, owner.Handle, out made));
    Handle = new Handle(made, Native.flinch_library_free);
  }
  private Library(Handle made) { Handle = made; }
  /// <summary>Takes the bytes of a library's file, which has clips and no selector.</summary>
  public static Library Take(byte[] clips) {
    IntPtr made;
    Native.Check(Native.flinch_library_take(clips, (UIntPtr)clips.Length, out made));
    return new Library(new Handle(made, Native.flinch_library_free));
  }
  public void Dispose() { Handle.Dispose(); }

  /// <summary>Of libflinch, "MAJOR.MINOR.PATCH".</summary>
  public static string Version { get { return Native.Text(Native.flinch_version()); } }

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
  /// <summary>A kind of threat that the library was trained for, from 0 to KindCount - 1.</summary>
  public unsafe ThreatKind Kind(int index) {
    var kind = new ThreatKind { Size = (uint)sizeof(ThreatKind) };
    Native.Check(Native.flinch_library_kind(Handle, index, ref kind));
    return kind;
  }
  public unsafe Skeleton Skeleton() {
    var skeleton = new Skeleton { Size = (uint)sizeof(Skeleton) };
    Native.Check(Native.flinch_library_skeleton(Handle, ref skeleton));
    return skeleton;
  }
  /// <summary>The shape and mass of a body, from 0 to Outline.Bodies - 1.</summary>
  public unsafe Outline Outline(int body) {
    var outline = new Outline { Size = (uint)sizeof(Outline) };
    Native.Check(Native.flinch_library_outline(Handle, body, ref outline));
    return outline;
  }
  /// <summary>The clip that a stance plays; -1: there is no such stance.</summary>
  public int Stance(int stance) { return Native.flinch_library_stance(Handle, stance); }
  public void ComputeJoints(ref Pose pose, ref JointFrames frames) {
    Native.Check(Native.flinch_library_joint_frames(Handle, ref pose, ref frames));
  }
  /// <summary>Writes the pose of a clip at a time of it, above the world's origin.</summary>
  public void GetClipPose(int clip, float time_s, ref Pose pose) {
    Native.Check(Native.flinch_library_clip_pose(Handle, clip, time_s, ref pose));
  }
  public static string JointName(int joint) { return Native.Text(Native.flinch_joint_name(joint)); }
  public static string BodyName(int body) { return Native.Text(Native.flinch_body_name(body)); }
  public static int JointParent(int joint) { return Native.flinch_joint_parent(joint); }
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

/// <summary>The moments of a library's everyday clips that can follow each other. Immutable.</summary>
public sealed class MotionGraph : IDisposable {
  internal readonly Handle Handle;

  public MotionGraph(Library library) {
    IntPtr made;
    Native.Check(Native.flinch_motion_graph_create(library.Handle, out made));
    Handle = new Handle(made, Native.flinch_motion_graph_free);
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
  /// <summary>A character that takes hits as the options say.</summary>
  public Character(Library library, ReactionOptions options) {
    IntPtr made;
    Native.Check(
        Native.flinch_character_create_reacting_as(library.Handle, ref options, out made));
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

  /// <summary>From now on it moves about by the graph, within the circle about (x, y).</summary>
  public void Walk(MotionGraph graph, ulong seed, float x = 0, float y = 0,
                   float radius = float.PositiveInfinity) {
    Native.Check(Native.flinch_character_walk(handle, graph.Handle, seed, x, y, radius));
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
  /// <summary>Writes the numbers of the threat that are outside of what the library was trained
  /// for; returns how many.</summary>
  public int OutsideTraining(ref Threat threat, Outside[] outside) {
    int count;
    Native.Check(Native.flinch_character_outside_training(handle, ref threat, outside,
                                                          outside.Length, out count));
    return count;
  }

  // The steps of perceiving, for games that choose among the answers themselves.

  public Answer Notice(ref Threat threat, out Perception perception) {
    perception = Perception.Make();
    return Native.Check(Native.flinch_character_notice(handle, ref threat, ref perception));
  }
  /// <summary>Writes the threats that will hit, the most urgent first; `count` says how many.</summary>
  public Answer NoticeAll(Threat[] threats, Perception[] perceptions, out int count) {
    if (perceptions.Length > 0) perceptions[0] = Perception.Make();
    return Native.Check(Native.flinch_character_notice_all(
        handle, threats, threats.Length, perceptions, perceptions.Length, out count));
  }
  /// <summary>Writes the clips that the selector considers, best first; returns their number.</summary>
  public int Rank(ref Perception perception, Workspace workspace, Candidate[] candidates) {
    int count;
    Native.Check(Native.flinch_character_rank(handle, ref perception, workspace.Handle, candidates,
                                              candidates.Length, out count));
    return count;
  }
  public Answer Plan(ref Perception perception, int clip, out Plan plan) {
    plan = new Plan { Size = (uint)sizeof(Plan) };
    return Native.Check(Native.flinch_character_plan(handle, ref perception, clip, ref plan));
  }
  /// <summary>Writes the pose of the planned response, s after the reaction delay.</summary>
  public Answer GetPlannedPose(ref Perception perception, int clip, float time_s, ref Pose pose) {
    return Native.Check(
        Native.flinch_character_planned_pose(handle, ref perception, clip, time_s, ref pose));
  }
  /// <summary>Starts the planned response; the first `count` candidates are kept.</summary>
  public Answer Answer(ref Perception perception, int clip, Candidate[] candidates, int count) {
    return Native.Check(
        Native.flinch_character_answer(handle, ref perception, clip, candidates, count));
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
  /// <summary>Simulates the selector's best clips and answers with the one that costs least. No
  /// more are tried when the budget is spent.</summary>
  public Answer LookAhead(Threat[] threats, int candidates, LookAhead memory,
                          float budget_us = float.PositiveInfinity) {
    LookAheadStatus status;
    return LookAhead(threats, candidates, memory, budget_us, out status);
  }
  /// <summary>The same, and tells what was found out.</summary>
  public Answer LookAhead(Threat[] threats, int candidates, LookAhead memory, float budget_us,
                          out LookAheadStatus status) {
    status = new LookAheadStatus { Size = (uint)sizeof(LookAheadStatus) };
    var options = new LookAheadOptions {
      Size = (uint)sizeof(LookAheadOptions), Candidates = candidates, Budget_us = budget_us,
      Now_us = float.IsPositiveInfinity(budget_us) ? IntPtr.Zero : Clock.Now_us
    };
    return Native.Check(Native.flinch_character_look_ahead(handle, threats, threats.Length,
                                                           ref options, memory.Handle, ref status));
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

}
