// SPDX-License-Identifier: MIT
// Throws one ball at a character: mono Throw.exe SELECTOR
using System;
using FlinchGame;

static class Throw {
  static unsafe void Main(string[] arguments) {
    var library = new Library(arguments[0]);
    var workspace = new Workspace(library);
    var character = new Character(library);
    var ball = Threat.Ball(9, 1, 1.4F, -20, -2.2F, 2.8F);
    Console.WriteLine(character.Perceive(ref ball, workspace));
    Pose pose = Pose.Make();
    JointFrames frames = JointFrames.Make();
    for (int frame = 0; frame < 60; ++frame) {
      character.Update(1 / 60F);
      character.GetPose(ref pose);
      library.ComputeJoints(ref pose, ref frames);
      Console.WriteLine(character.Describe().Phase + " head at " + frames.Position[3 * 4 + 2]);
    }
  }
}
