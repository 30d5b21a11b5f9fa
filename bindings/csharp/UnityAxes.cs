// SPDX-License-Identifier: MIT
namespace FlinchGame {

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

}
