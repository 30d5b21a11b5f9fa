# SPDX-License-Identifier: MIT
# Prints where Godot 3 has the joints of clips.glb at the samples of joints.json, as one line of JSON.
extends SceneTree


func _initialize():
	var file = File.new()
	file.open("res://joints.json", File.READ)
	var samples = parse_json(file.get_as_text())
	file.close()
	var scene = load("res://clips.glb").instance()
	root.add_child(scene)
	var player = found(scene, "AnimationPlayer")
	var skeleton = found(scene, "Skeleton")
	var all = []
	for sample in samples:
		player.play(sample["animation"])
		player.seek(sample["time_s"], true)
		var joints = {}
		for bone in skeleton.get_bone_count():
			var place = skeleton.global_transform * skeleton.get_bone_global_pose(bone).origin
			joints[skeleton.get_bone_name(bone)] = [place.x, place.y, place.z]
		all.append(joints)
	print("joints: ", to_json(all))
	quit()


# The first node of a class at or below a node.
func found(node, kind):
	if node.get_class() == kind:
		return node
	for child in node.get_children():
		var below = found(child, kind)
		if below != null:
			return below
	return null
