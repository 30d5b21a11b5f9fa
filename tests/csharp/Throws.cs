// SPDX-License-Identifier: MIT
// Throws.exe SELECTOR LIBRARY: does in C# what tests/throws/throws.c does, and prints the same.
using System;
using System.Globalization;
using System.IO;
using System.Text;
using FlinchGame;

static unsafe class Throws {
  const int Count = 300, Hits = 20, Walks = 30, Frames = 20;

  static ulong state = 1;
  static float Uniform(float low, float high) {
    state = state * 6364136223846793005 + 1442695040888963407;
    float share = (float)(state >> 40) / (float)(1 << 24);
    float scaled = (float)((high - low) * share);
    return (float)(low + scaled);
  }

  static Threat Ball() {
    float x, y, square;
    do {
      x = Uniform(-9, 9);
      y = Uniform(-9, 9);
      float xx = (float)(x * x), yy = (float)(y * y);
      square = (float)(xx + yy);
    } while (square < 9 || square > 81);
    float fromZ = Uniform(0.5F, 2);
    float toX = Uniform(-0.3F, 0.3F), toY = Uniform(-0.3F, 0.3F), toZ = Uniform(0.3F, 1.8F);
    float flight_s = Uniform(0.3F, 1.1F);
    float rise = (float)((float)(9.81F * flight_s) / 2);
    float up = (float)((float)(toZ - fromZ) / flight_s);
    Threat threat = Threat.Ball(x, y, fromZ, (float)((float)(toX - x) / flight_s),
                                (float)((float)(toY - y) / flight_s), (float)(up + rise));
    threat.Radius = Uniform(0.03F, 0.2F);
    threat.Mass_kg = Uniform(0.1F, 1);
    return threat;
  }

  static void PrintClip(Character character, string how, Answer answer) {
    Console.WriteLine(how + " " + (int)answer + " " + character.Describe().Clip);
  }

  static void PlayAndPrint(Character character) {
    for (int frame = 0; frame < Frames; ++frame) character.Update(1.0F / 60);
    Pose pose = Pose.Make();
    character.GetPose(ref pose);
    PrintPose(pose);
  }

  static void PrintNumbers(params float[] numbers) {
    var line = new StringBuilder("pose");
    foreach (float number in numbers)
      line.Append(' ').Append(number.ToString("G9", CultureInfo.InvariantCulture));
    Console.WriteLine(line);
  }

  static void PrintPose(Pose pose) {
    var numbers = new float[3 + 4 * Pose.Joints];
    for (int i = 0; i < 3; ++i) numbers[i] = pose.RootPosition[i];
    for (int i = 0; i < 4 * Pose.Joints; ++i) numbers[3 + i] = pose.Rotation[i];
    PrintNumbers(numbers);
  }

  static void AnswerBySteps(Character character, Threat threat, Workspace workspace) {
    Perception noticed;
    Answer hits = character.Notice(ref threat, out noticed);
    Console.WriteLine("notices " + (int)hits + " " + (int)noticed.Target);
    if (hits != Answer.Ok) return;
    var best = new Candidate[8];
    int count = character.Rank(ref noticed, workspace, best);
    Plan plan;
    character.Plan(ref noticed, best[0].Clip, out plan);
    PrintNumbers(plan.FirstMotion_s, plan.Begin_s, plan.Peak_s, plan.End_s, plan.Duration_s,
                 plan.PlaybackRate);
    Pose pose = Pose.Make();
    character.GetPlannedPose(ref noticed, best[0].Clip, 0.3F, ref pose);
    PrintPose(pose);
    PrintClip(character, "answers", character.Answer(ref noticed, best[0].Clip, best, count));
    PlayAndPrint(character);
  }

  static void Walk(string path) {
    Library library = Library.Take(File.ReadAllBytes(path));
    var character = new Character(library);
    using (var graph = new MotionGraph(library)) character.Walk(graph, 7, 0, 0, 3);
    for (int i = 0; i < Walks; ++i) {
      Threat threat = Ball();
      PlayAndPrint(character);
      PrintClip(character, "braces", character.Brace(ref threat));
    }
  }

  static void Require(bool condition, string what) {
    if (!condition) throw new InvalidOperationException(what);
  }

  static void Refuses(int status, Action act) {
    try {
      act();
    } catch (FlinchException error) {
      Require(error.Status == status, error.Message);
      return;
    }
    Require(false, "status " + status);
  }

  // The axes: a turn of Flinch's vector is the same turn of Unity's, there and back.
  static void CheckAxes() {
    for (int i = 0; i < 100; ++i) {
      double[] q = new double[4];
      double norm = 0;
      for (int k = 0; k < 4; ++k) {
        q[k] = Uniform(-1, 1);
        norm += q[k] * q[k];
      }
      for (int k = 0; k < 4; ++k) q[k] /= Math.Sqrt(norm);
      float x = Uniform(-1, 1), y = Uniform(-1, 1), z = Uniform(-1, 1);
      double[] turned = Turned(q[0], q[1], q[2], q[3], x, y, z);
      float ux, uy, uz, qx, qy, qz, qw;
      UnityAxes.Position((float)turned[0], (float)turned[1], (float)turned[2], out ux, out uy, out uz);
      UnityAxes.Rotation((float)q[0], (float)q[1], (float)q[2], (float)q[3], out qx, out qy, out qz,
                         out qw);
      float vx, vy, vz;
      UnityAxes.Position(x, y, z, out vx, out vy, out vz);
      double[] there = Turned(qw, qx, qy, qz, vx, vy, vz);
      Require(Math.Abs(there[0] - ux) + Math.Abs(there[1] - uy) + Math.Abs(there[2] - uz) < 1e-5,
              "axes");
      float w, bx, by, bz;
      UnityAxes.RotationBack(qx, qy, qz, qw, out w, out bx, out by, out bz);
      Require(w == (float)q[0] && bx == (float)q[1] && by == (float)q[2] && bz == (float)q[3], "back");
      UnityAxes.PositionBack(vx, vy, vz, out bx, out by, out bz);
      Require(bx == x && by == y && bz == z, "position back");
    }
    float fx, fy, fz;
    UnityAxes.Position(1, 0, 0, out fx, out fy, out fz);
    Require(fx == 0 && fy == 0 && fz == 1, "forward is Z");
    UnityAxes.Position(0, 1, 0, out fx, out fy, out fz);
    Require(fx == -1 && fy == 0 && fz == 0, "left is -X");
  }

  // v + 2 u x (u x v + w v): the same formula in both engines, whatever the hand.
  static double[] Turned(double w, double x, double y, double z, double a, double b, double c) {
    double p = y * c - z * b + w * a, q = z * a - x * c + w * b, r = x * b - y * a + w * c;
    return new[] { a + 2 * (y * r - z * q), b + 2 * (z * p - x * r), c + 2 * (x * q - y * p) };
  }

  static void CheckErrors(Library library, string selector) {
    try {
      new Character(library).Update(-1);
      Require(false, "a negative time step");
    } catch (FlinchException error) {
      Require(error.Status == -8 && error.Message.Contains("time"), error.Message);
    }
    byte[] damaged = File.ReadAllBytes(selector);
    damaged[damaged.Length / 2] ^= 1;
    try {
      new Library(damaged);
      Require(false, "a damaged file");
    } catch (FlinchException error) {
      Require(error.Status == -23 && error.Message.Contains("damaged"), error.Message);
    }
    new Library(File.ReadAllBytes(selector)).Dispose();
    LibraryInfo info = library.Describe();
    Clip clip = library.Clip(info.ClipCount - 1);
    Require(info.Rate_hz == 60 && clip.Name.Length > 0 && clip.Duration_s > 0 &&
            clip.End_s <= clip.Duration_s, "clip");
    Require(Library.JointName(4) == "head" && Library.JointParent(4) == 3, "joints");
  }

  static void CheckOthers(Library library, Workspace workspace) {
    var character = new Character(library);
    Threat ball = Threat.Ball(9, 1, 1.4F, -20, -2.2F, 2.8F);
    Require(character.PerceiveAll(new[] { ball, ball }, workspace) == Answer.Ok, "two");
    var candidates = new Candidate[8];
    Require(character.Candidates(candidates) > 0 &&
            candidates[0].Clip == character.Describe().Clip, "candidates");
    Require(character.PerceiveKnown(ref ball, Target.Legs, 0.5F, workspace) == Answer.Ok &&
            character.Describe().Target == Target.Legs, "known");
    Require(character.Brace(ref ball) == Answer.Ok && character.Describe().Clip == -1, "brace");
    PerceptionLimits limits = PerceptionLimits.Human(4);
    limits.ChanceToFail = 1;
    character.LimitPerception(ref limits, 3);
    Require(character.Perceive(ref ball, workspace) == Answer.Unnoticed, "unnoticed");
    Pose game = Pose.Make(), mixed = Pose.Make();
    character.GetPose(ref game);
    game.RootPosition[0] += 1;
    Mask mask = Mask.Make();
    character.GetPoseOver(ref game, ref mask, ref mixed);
    Require(mixed.RootPosition[0] == game.RootPosition[0], "mask of the game");
    var twin = new Character(library);
    twin.CopyFrom(character);
    twin.GetPose(ref mixed);
    character.GetPose(ref game);
    Require(mixed.RootPosition[2] == game.RootPosition[2] &&
            twin.Describe().Phase == character.Describe().Phase, "copy");
    game.RootPosition[0] += 1;
    library.GetClipPose(library.Describe().IdleClip, 0, ref mixed);
    Require(Math.Abs(mixed.RootPosition[0]) < 0.1 && mixed.RootPosition[2] > 0.5, "clip pose");
    mask.Joint[0] = 1;
    character.GetPoseOver(ref game, ref mask, ref mixed);
    Require(Math.Abs(mixed.RootPosition[0] - game.RootPosition[0] + 1) < 1e-5, "mask of Flinch");
  }

  static void CheckLibrary(Library library) {
    Require(Library.Version.Split('.').Length == 3, "version");
    ThreatKind kind = library.Kind(0);
    Require(kind.Shape == Shape.Ball && kind.Name.Length > 0 && kind.Speed_mps[0] > 1 &&
            kind.Speed_mps[1] > kind.Speed_mps[0] && kind.Length_m[1] == 0, "kind");
    Skeleton skeleton = library.Skeleton();
    Require(skeleton.Offset[2] > 0.8F && skeleton.Tip[3 * 4 + 2] > 0.1F, "pelvis and head");
    float mass_kg = 0;
    for (int body = 0; body < Outline.Bodies; ++body) mass_kg += library.Outline(body).Mass_kg;
    Require(Math.Abs(mass_kg - library.Describe().Mass_kg) < 1e-3, "masses of the bodies");
    Require(Library.BodyName(0) == "pelvis" && library.Stance(0) == library.Describe().IdleClip &&
            library.Stance(99) == -1, "stances");
  }

  // A selector without clips, in the file of that name in the environment, plays those of a library
  // that it shares.
  static void CheckSharedClips(string selector, string otherClips) {
    byte[] bare = File.ReadAllBytes(Environment.GetEnvironmentVariable("BARE_SELECTOR"));
    Refuses(-25, () => new Library(bare));
    Refuses(-30, () => new Library(bare, Library.Take(File.ReadAllBytes(otherClips))));
    Library whole = new Library(selector), owner = new Library(selector);
    var shared = new Library(bare, owner);
    owner.Dispose();
    Pose expected = Pose.Make(), pose = Pose.Make();
    for (int i = 0; i < 20; ++i) {
      Threat ball = Ball();
      foreach (Library library in new[] { whole, shared }) {
        var character = new Character(library);
        character.Perceive(ref ball, new Workspace(library));
        for (int frame = 0; frame < Frames; ++frame) character.Update(1.0F / 60);
        character.GetPose(ref pose);
        if (library == whole) expected = pose;
      }
      for (int k = 0; k < 4 * Pose.Joints; ++k)
        Require(pose.Rotation[k] == expected.Rotation[k], "the pose of shared clips");
    }
  }

  static void CheckSteps(Library library, Workspace workspace) {
    var character = new Character(library);
    Threat ball = Threat.Ball(9, 1, 1.4F, -20, -2.2F, 2.8F), away = ball;
    away.Velocity[0] = 20;
    var noticed = new Perception[4];
    int count;
    Answer hits = character.NoticeAll(new[] { away, ball }, noticed, out count);
    Threat first = noticed[0].Threat;
    Require(hits == Answer.Ok && count == 1 && first.Velocity[0] < 0, "the one that hits");
    ball.Mass_kg = 5;
    var outside = new Outside[8];
    character.Perceive(ref ball, workspace);
    Require(character.OutsideTraining(ref ball, outside) > 0 && outside[0].Name == "mass_kg" &&
            outside[0].Value == 5 && outside[0].TrainedTo < 5, "outside of training");
  }

  static void CheckLookAhead(Library library, LookAhead memory) {
    var threats = new[] { Threat.Ball(9, 1, 1.4F, -20, -2.2F, 2.8F) };
    LookAheadStatus all, none;
    new Character(library).LookAhead(threats, 8, memory, float.PositiveInfinity, out all);
    new Character(library).LookAhead(threats, 8, memory, 0, out none);
    Require(all.IsComplete == 1 && all.Tried > none.Tried, "a budget of nothing");
    float chosen = all.Candidate(all.Chosen).Cost_ns;
    for (int i = 0; i < all.CandidateCount; ++i)
      Require(!(all.Candidate(i).Cost_ns < chosen), "the cheapest");
  }

  // A soft body goes on moving by physics for as long as the options say.
  static void CheckHits(Library library) {
    ReactionOptions options = ReactionOptions.Make();
    options.SimulationOnly_s = 0.5F;
    Threat ball = Threat.Ball(1.5F, 0, 1.2F, -20, 0, 0);
    var usual = new Character(library, true);
    var soft = new Character(library, options);
    usual.ReactTo(ref ball);
    soft.ReactTo(ref ball);
    for (int frame = 0; frame < 24; ++frame) {
      usual.Update(1 / 60F);
      soft.Update(1 / 60F);
    }
    Require(usual.DescribeReaction().Phase != ReactionPhase.Struck &&
            soft.DescribeReaction().Phase == ReactionPhase.Struck, "options of a reaction");
    options.Stiffness = 2;
    try {
      new Character(library, options);
      Require(false, "too stiff");
    } catch (FlinchException error) {
      Require(error.Status == -11, error.Message);
    }
  }

  static void Main(string[] arguments) {
    var library = new Library(arguments[0]);
    var workspace = new Workspace(library);
    var lookAhead = new LookAhead(library);
    var character = new Character(library, true);
    for (int i = 0; i < Count; ++i) {
      Threat threat = Ball();
      character.Place(0, 0, 0, 0.5F);
      PrintClip(character, "perceives", character.Perceive(ref threat, workspace));
      PlayAndPrint(character);
      PlayAndPrint(character);
    }
    for (int i = 0; i < Hits; ++i) {
      Threat threat = Ball();
      character.Place(0, 0, 0, 0.5F);
      PrintClip(character, "looks ahead", character.LookAhead(new[] { threat }, 4, lookAhead));
      character.Place(0, 0, 0, 0.5F);
      character.ReactTo(ref threat);
      PlayAndPrint(character);
      PlayAndPrint(character);
      Require(character.DescribeReaction().Phase != ReactionPhase.None, "reaction");
      character.Place(0, 0, 0, 0.5F);
      AnswerBySteps(character, threat, workspace);
    }
    Walk(arguments[1]);
    CheckAxes();
    CheckErrors(library, arguments[0]);
    CheckOthers(library, workspace);
    CheckLibrary(library);
    CheckSteps(library, workspace);
    CheckLookAhead(library, lookAhead);
    CheckHits(library);
    CheckSharedClips(arguments[0], arguments[1]);
  }
}
