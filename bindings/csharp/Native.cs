// SPDX-License-Identifier: MIT
// What the binding calls in libflinch.so or flinch.dll.
using System;
using System.Diagnostics;
using System.Runtime.InteropServices;
using System.Text;

namespace FlinchGame {

[StructLayout(LayoutKind.Sequential)]
internal struct LookAheadOptions {
  public uint Size;
  public int Candidates;
  public float Budget_us;
  private int reserved;
  public IntPtr Now_us;
  private IntPtr clock;
}

/// What Unity's IL2CPP looks for, by its name, on a function that C calls.
[AttributeUsage(AttributeTargets.Method)]
internal sealed class MonoPInvokeCallbackAttribute : Attribute {
  public MonoPInvokeCallbackAttribute(Type type) {}
}

/// The time of Stopwatch, us, for budgets.
internal static class Clock {
  [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
  private delegate double Reader(IntPtr clock);
  private static readonly Reader reader = Read;  // kept, since C calls it
  internal static readonly IntPtr Now_us = Marshal.GetFunctionPointerForDelegate(reader);

  [MonoPInvokeCallback(typeof(Reader))]
  private static double Read(IntPtr clock) {
    return Stopwatch.GetTimestamp() * (1e6 / Stopwatch.Frequency);
  }
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
  [DllImport(Flinch)] internal static extern int flinch_character_look_ahead(Handle character, [In] Threat[] threats, int count, ref LookAheadOptions options, Handle lookAhead, ref LookAheadStatus status);
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
  [DllImport(Flinch)] internal static extern IntPtr flinch_version();
  [DllImport(Flinch)] internal static extern IntPtr flinch_body_name(int body);
  [DllImport(Flinch)] internal static extern int flinch_library_load_beside(byte[] bytes, UIntPtr count, Handle owner, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_library_take(byte[] bytes, UIntPtr count, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_library_skeleton(Handle library, ref Skeleton skeleton);
  [DllImport(Flinch)] internal static extern int flinch_library_outline(Handle library, int body, ref Outline outline);
  [DllImport(Flinch)] internal static extern int flinch_library_kind(Handle library, int index, ref ThreatKind kind);
  [DllImport(Flinch)] internal static extern int flinch_library_stance(Handle library, int stance);
  [DllImport(Flinch)] internal static extern int flinch_motion_graph_create(Handle library, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_motion_graph_free(IntPtr graph);
  [DllImport(Flinch)] internal static extern int flinch_reaction_defaults(ref ReactionOptions options);
  [DllImport(Flinch)] internal static extern int flinch_character_create_reacting_as(Handle library, ref ReactionOptions options, out IntPtr made);
  [DllImport(Flinch)] internal static extern int flinch_character_outside_training(Handle character, ref Threat threat, [Out] Outside[] outside, int capacity, out int count);
  [DllImport(Flinch)] internal static extern int flinch_character_notice(Handle character, ref Threat threat, ref Perception perception);
  [DllImport(Flinch)] internal static extern int flinch_character_notice_all(Handle character, [In] Threat[] threats, int count, [In, Out] Perception[] perceptions, int capacity, out int noticed);
  [DllImport(Flinch)] internal static extern int flinch_character_rank(Handle character, ref Perception perception, Handle workspace, [Out] Candidate[] candidates, int capacity, out int count);
  [DllImport(Flinch)] internal static extern int flinch_character_plan(Handle character, ref Perception perception, int clip, ref Plan plan);
  [DllImport(Flinch)] internal static extern int flinch_character_planned_pose(Handle character, ref Perception perception, int clip, float time_s, ref Pose pose);
  [DllImport(Flinch)] internal static extern int flinch_character_answer(Handle character, ref Perception perception, int clip, [In] Candidate[] candidates, int count);
  [DllImport(Flinch)] internal static extern int flinch_character_walk(Handle character, Handle graph, ulong seed, float x, float y, float radius);
}

}
