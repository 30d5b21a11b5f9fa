# SPDX-License-Identifier: MIT
"""Raw takes of a made-up figure, as BVH files."""

ZXY = "CHANNELS 3 Zrotation Xrotation Yrotation"
# A standing figure in centimetres, Y up, Z forward: joint, its parent, its OFFSET.
JOINTS = [("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 12, 0)), ("Chest", "Spine", (0, 15, 0)),
          ("Neck", "Chest", (0, 25, 0)), ("Head", "Neck", (0, 9, 0))]
END_SITES = {"Head": (0, 18, 0)}
for side, sign in (("Left", 1), ("Right", -1)):
    JOINTS += [(side + "Shoulder", "Chest", (sign * 3, 18, 0)),
               (side + "Arm", side + "Shoulder", (sign * 15, 0, 0)),
               (side + "ForeArm", side + "Arm", (sign * 28, 0, 0)),
               (side + "Hand", side + "ForeArm", (sign * 25, 0, 0)),
               (side + "UpLeg", "Hips", (sign * 9, 0, 0)),
               (side + "Leg", side + "UpLeg", (0, -42, 0)),
               (side + "Foot", side + "Leg", (0, -41, 0)),
               (side + "Toe", side + "Foot", (0, -7, 14))]
    END_SITES |= {side + "Hand": (sign * 18, 0, 0), side + "Toe": (0, 0, 6)}


def joint_text(name, offset):
    lines = [("JOINT " if name != "Hips" else "ROOT ") + name, "{",
             "OFFSET {} {} {}".format(*offset)]
    lines.append(ZXY if name != "Hips" else
                 "CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation")
    lines += [joint_text(child, at) for child, parent, at in JOINTS if parent == name]
    if name in END_SITES:
        lines.append("End Site {{ OFFSET {} {} {} }}".format(*END_SITES[name]))
    return "\n".join(lines + ["}"])


def depth_first(name="Hips"):
    yield name
    for child, parent, _ in JOINTS:
        if parent == name:
            yield from depth_first(child)


def take(frames, degrees_at):
    """A BVH file at 30 Hz. `degrees_at` gives how far the left arm is raised sideways from below."""
    rows = []
    for frame in range(frames):
        row = ["0 90 0 0 0 0"]
        for joint in list(depth_first())[1:]:
            angle = {"LeftArm": degrees_at(frame / 30) - 90, "RightArm": 90}.get(joint, 0)
            row.append(f"{angle} 0 0")
        rows.append(" ".join(row))
    return (f"HIERARCHY\n{joint_text('Hips', (0, 0, 0))}\nMOTION\nFrames: {frames}\n"
            "Frame Time: 0.0333333\n" + "\n".join(rows) + "\n")
