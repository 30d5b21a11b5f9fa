# SPDX-License-Identifier: MIT
"""The run time in Python. Environment: SELECTOR, BARE_SELECTOR (the same without clips), WALKS (a library with
everyday motion), FLINCH (the program), FLINCH_LIBRARY (libflinch.so)."""

import ctypes
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy

import flinch

SELECTOR = pathlib.Path(os.environ["SELECTOR"])
BARE_SELECTOR = pathlib.Path(os.environ["BARE_SELECTOR"])
WALKS = pathlib.Path(os.environ["WALKS"])
BALL = flinch.Threat([9, 1, 1.4], [-20, -2.2, 2.8])
AWAY = flinch.Threat([9, 1, 1.4], [20, 0, 0])


def message_of(status):
    library = ctypes.CDLL(os.environ["FLINCH_LIBRARY"])
    library.flinch_status_message.restype = ctypes.c_char_p
    return library.flinch_status_message(status).decode()


def numbers(pose):
    return numpy.concatenate([pose.root_position, pose.rotation.ravel()])


class Runtime(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.library = flinch.Library(SELECTOR)

    def setUp(self):
        self.character = flinch.Character(self.library)

    def refuses(self, status, call, *arguments, **options):
        with self.assertRaises(flinch.Error) as caught:
            call(*arguments, **options)
        self.assertEqual(caught.exception.status, status)
        self.assertEqual(str(caught.exception), message_of(status))

    def test_a_ball_is_answered_and_the_character_returns_to_idle(self):
        self.assertEqual(self.character.perceive(AWAY), "misses")
        self.assertEqual(self.character.perceive(BALL), "ok")
        self.assertEqual(self.character.clip, self.character.candidates[0]["clip"])
        self.assertEqual(self.library.clips[self.character.clip]["target"] in flinch.TARGETS, True)
        self.assertGreater(self.character.time_to_impact_s, 0.3)
        phases = set()
        for _ in range(300):
            self.character.update(1 / 60)
            phases.add(self.character.phase)
        self.assertIn("protecting", phases)
        self.assertEqual(self.character.phase, "idle")

    def test_a_crowd_does_what_each_character_does_alone(self):
        count = 40
        random = numpy.random.default_rng(1)
        position = random.uniform(-50, 50, (count, 2))
        facing = random.uniform(-3, 3, count)
        time_s = random.uniform(0, 2, count)
        start = numpy.c_[position + random.uniform(2, 6, (count, 2)), random.uniform(0.5, 2, count)]
        velocity = (numpy.c_[position, numpy.full(count, 2.4)] - start) / 0.5
        crowd = flinch.Crowd(self.library, count)
        crowd.place(position, facing, time_s)
        answers = crowd.perceive(start, velocity, radius=0.2)
        for _ in range(25):
            crowd.update(1 / 60)
        root, rotation = crowd.poses()
        self.assertEqual((len(crowd), root.shape, rotation.shape), (count, (count, 3), (count, 21, 4)))
        for i in range(count):
            self.character.place(*position[i], facing[i], time_s[i])
            answer = self.character.perceive(flinch.Threat(start[i], velocity[i], radius=0.2))
            self.assertEqual(["ok", "misses", "unnoticed", "outside_training"][answers[i]], answer)
            for _ in range(25):
                self.character.update(1 / 60)
            numpy.testing.assert_array_equal(numpy.r_[root[i], rotation[i].ravel()],
                                             numbers(self.character.pose()))
            numpy.testing.assert_array_equal(crowd.joint_positions()[i],
                                             self.library.joint_frames(self.character.pose())[0])
            self.assertEqual(crowd.clips()[i], self.character.clip)
            numpy.testing.assert_array_equal(numbers(crowd[i].pose()), numbers(self.character.pose()))
        self.assertGreater(len(set(crowd.clips())), 3)
        self.assertRaises(IndexError, lambda: crowd[count])
        self.assertEqual(crowd[-1].clip, crowd.clips()[-1])

    def test_joint_frames_are_the_skeletons(self):
        offset, tip = self.library.skeleton
        self.assertEqual((offset.shape, tip.shape), ((21, 3), (21, 3)))
        positions, _ = self.library.joint_frames(self.character.pose())
        for joint, parent in enumerate(flinch.JOINT_PARENTS):
            if parent >= 0:  # bones keep their length
                self.assertAlmostEqual(numpy.linalg.norm(positions[joint] - positions[parent]),
                                       numpy.linalg.norm(offset[joint]), places=5)
        self.assertAlmostEqual(sum(body["mass_kg"] for body in self.library.bodies),
                               self.library.mass_kg, places=3)

    def test_a_pose_of_the_game_shows_through_by_the_mask(self):
        game = flinch.Pose([1, 2, 3], numpy.tile([1, 0, 0, 0], (21, 1)))
        kept = self.character.pose_over(game, numpy.zeros(21))
        numpy.testing.assert_array_equal(numbers(kept), numbers(game))
        taken = self.character.pose_over(game, numpy.ones(21))
        numpy.testing.assert_allclose(numbers(taken), numbers(self.character.pose()), atol=1e-6)
        self.character.set_pose(self.character.pose(), self.character.pose(), 1 / 60)

    def test_looking_ahead_takes_the_cheapest(self):
        found = self.character.look_ahead([BALL], candidates=8)
        self.assertEqual(found["answer"], "ok")
        self.assertTrue(found["is_complete"])
        chosen = found["candidates"][found["chosen"]]
        self.assertEqual(self.character.clip, chosen["clip"])
        self.assertEqual(chosen["cost_ns"], numpy.nanmin([c["cost_ns"] for c in found["candidates"]]))
        self.character.place()
        hurried = self.character.look_ahead([BALL], candidates=8, budget_us=0)
        self.assertLess(hurried["tried"], found["tried"])

    def test_a_hit_reaches_the_body(self):
        character = flinch.Character(self.library, reacting=True)
        character.react_to(flinch.Threat([1.5, 0, 1.2], [-20, 0, 0]))
        for _ in range(30):
            character.update(1 / 60)
        reaction = character.reaction
        self.assertGreater(reaction["impulse_ns"].sum(), 0.5)
        self.assertLess(reaction["contact_s"], 0.1)
        self.refuses(-14, self.character.react_to, BALL)
        character.react_to(flinch.Threat([1.5, 0, 1.2], [-20, 0, 0]))
        character.update(1 / 60)
        self.assertEqual(character.reaction["moved_by"], "physics")
        character.stop_reaction()
        self.assertEqual(character.reaction["moved_by"], "character")

    def test_a_hit_gives_the_figure_what_the_ball_loses(self):
        character = flinch.Character(self.library, reacting=True)
        velocity = numpy.array([-20, 0, 0])
        character.react_to(flinch.Threat([1.5, 0, 1.2], velocity, mass_kg=0.5))
        for _ in range(6):
            character.update(1 / 60)
        reaction = character.reaction
        # Gravity has changed the ball's velocity, too, but only along Z.
        lost = 0.5 * (velocity - reaction["ball_velocity"])
        numpy.testing.assert_allclose(reaction["ball_momentum"][:2], lost[:2], atol=1e-4)
        self.assertLess(reaction["ball_momentum"][0], -5)
        numpy.testing.assert_array_equal(reaction["ball_axis"], [0, 0, 0])

    def test_options_say_how_a_character_takes_a_hit(self):
        def phase_after_a_hit(**options):
            character = flinch.Character(self.library, reacting=True, **options)
            character.react_to(flinch.Threat([1.5, 0, 1.2], [-20, 0, 0]))
            for _ in range(24):
                character.update(1 / 60)
            return character.reaction["phase"]

        self.assertEqual(phase_after_a_hit(simulation_only_s=0.5), "struck")
        self.assertNotEqual(phase_after_a_hit(stiffness=0.1), "struck")
        self.refuses(-11, flinch.Character, self.library, reacting=True, stiffness=2)
        with self.assertRaisesRegex(ValueError, "are for reacting=True"):
            flinch.Character(self.library, stiffness=0.1)

    def test_steps_do_what_perceiving_does(self):
        self.assertEqual(self.character.notice(AWAY), ("misses", None))
        answer, noticed = self.character.notice(BALL)
        self.assertEqual(answer, "ok")
        twin = flinch.Character(self.library)
        twin.perceive(BALL)
        self.assertEqual(noticed.target, twin.target)
        best = self.character.rank(noticed)
        self.assertEqual(best, twin.candidates)
        plan = self.character.plan(noticed, best[0]["clip"])
        planned = [self.character.planned_pose(noticed, best[0]["clip"], frame / 60) for frame in range(61)]
        self.assertLess(plan["first_motion_s"], plan["peak_s"])
        self.assertAlmostEqual(plan["peak_s"], noticed.time_to_impact_s, places=3)
        self.assertEqual(self.character.phase, "idle")
        self.assertEqual(self.character.answer(noticed, best[0]["clip"], best), "ok")
        self.assertEqual(self.character.candidates, best)
        for frame in range(1, 61):
            self.character.update(1 / 60)
            twin.update(1 / 60)
            numpy.testing.assert_array_equal(numbers(self.character.pose()), numbers(twin.pose()))
            numpy.testing.assert_allclose(numbers(planned[frame]), numbers(twin.pose()), atol=1e-4)

    def test_perceptions_are_values(self):
        answer, noticed = self.character.notice_all([AWAY, BALL, BALL])
        self.assertEqual((answer, len(noticed)), ("ok", 2))
        one = noticed[0]
        same = flinch.Perception(one.threat, one.target, one.time_to_impact_s, one.delay_s, one.position,
                                 one.facing, one.stance_time_s, one.stance)
        self.assertEqual(self.character.rank(same), self.character.rank(one))
        late = flinch.Perception(BALL, "head", 0.1, delay_s=0.2)
        clip = self.character.rank(late)[0]["clip"]
        self.assertIsNone(self.character.plan(late, clip))
        self.assertIsNone(self.character.planned_pose(late, clip, 0.1))
        self.refuses(-7, self.character.rank, flinch.Perception(BALL, "head", -1))
        self.refuses(-6, self.character.plan, one, 9999)

    def test_a_library_without_a_selector_walks_and_answers_by_rule(self):
        library = flinch.Library.take(WALKS.read_bytes())
        graph = flinch.MotionGraph(library)
        character, twin = flinch.Character(library), flinch.Character(library)
        character.walk(graph, 7, 0, 0, 2)
        twin.walk(flinch.MotionGraph(library), 8, 0, 0, 2)
        self.assertEqual(character.phase, "walking")
        for _ in range(300):
            character.update(1 / 60)
            twin.update(1 / 60)
        self.assertFalse(numpy.array_equal(numbers(character.pose()), numbers(twin.pose())))
        x, y = character.pose().root_position[:2]
        near = flinch.Threat([x + 9, y + 1, 1.4], [-20, -2.2, 2.8])
        self.assertEqual((character.brace(near), character.clip), ("ok", -1))
        self.refuses(-18, character.perceive, near)
        self.refuses(-29, flinch.Library.take, SELECTOR.read_bytes())
        self.refuses(-4, flinch.Character(library).walk, flinch.MotionGraph(flinch.Library.take(WALKS.read_bytes())), 1)

    def test_a_selector_without_clips_plays_those_of_a_library_that_it_shares(self):
        bare = BARE_SELECTOR.read_bytes()
        self.refuses(-25, flinch.Library.from_bytes, bare)
        owner = flinch.Library(SELECTOR)
        shared = flinch.Library.load_beside(bare, owner)
        del owner
        character = flinch.Character(shared)
        for ball in (BALL, flinch.Threat([-6, 3, 1], [12, -6, 1]), flinch.Threat([2, 7, 0.5], [-4, -14, 3])):
            for one in (character, self.character):
                one.place(0, 0, 0, 0.5)
                self.assertEqual(one.perceive(ball), "ok")
                for _ in range(30):
                    one.update(1 / 60)
            self.assertEqual(character.candidates, self.character.candidates)
            numpy.testing.assert_array_equal(numbers(character.pose()), numbers(self.character.pose()))
        self.refuses(-30, flinch.Library.load_beside, bare, flinch.Library.take(WALKS.read_bytes()))
        self.refuses(-23, flinch.Library.load_beside, bare[:900], shared)

    def test_a_saved_state_goes_on_as_the_original(self):
        self.character.perceive(BALL)
        for _ in range(30):
            self.character.update(1 / 60)
        saved = flinch.Character(self.library)
        saved.copy_from(self.character)
        for _ in range(30):
            self.character.update(1 / 60)
            saved.update(1 / 60)
        numpy.testing.assert_array_equal(numbers(saved.pose()), numbers(self.character.pose()))

    def test_a_clips_pose_is_the_librarys(self):
        pose = self.library.clip_pose(self.library.idle_clip, 0)
        character = flinch.Character(self.library)
        numpy.testing.assert_allclose(pose.rotation, character.pose().rotation, atol=1e-5)
        last = len(self.library.clips) - 1
        duration_s = self.library.clips[last]["duration_s"]
        numpy.testing.assert_array_equal(numbers(self.library.clip_pose(last, duration_s)),
                                         numbers(self.library.clip_pose(last, 99)))
        self.refuses(-5, self.library.clip_pose, last + 1, 0)

    def test_perception_can_be_imperfect(self):
        self.character.limit_perception(seed=3, chance_to_fail=1)
        self.assertEqual(self.character.perceive(BALL), "unnoticed")
        limits = flinch.human_limits(4)
        self.assertGreater(limits["reaction_delay_s"], flinch.human_limits(1)["reaction_delay_s"])
        self.character.limit_perception(3, **{**limits, "chance_to_fail": 0})
        self.assertEqual(self.character.perceive(BALL), "ok")
        self.assertEqual(self.character.phase, "reacting")
        self.character.limit_perception()

    def test_other_answers(self):
        self.assertEqual(self.character.perceive([AWAY, BALL]), "ok")
        self.assertEqual(self.character.perceive_known(BALL, "legs", 0.5), "ok")
        self.assertEqual(self.character.target, "legs")
        self.assertEqual(self.character.brace(BALL), "ok")
        self.assertEqual(self.character.clip, -1)
        clip = next(i for i, c in enumerate(self.library.clips) if c.get("target") == "head")
        self.character.respond(clip, 0.5)
        self.assertEqual(self.character.clip, clip)
        self.character.settle()
        heavy = self.character.outside_training(flinch.Threat([9, 1, 1.4], [-20, -2.2, 2.8], mass_kg=5))
        value, (low, high) = heavy["mass_kg"]
        self.assertEqual(value, 5)
        self.assertLessEqual(low, high)
        self.assertEqual(self.library.stances[0], self.library.idle_clip)
        self.assertEqual(self.library.kinds[0]["shape"], "ball")

    def test_errors_have_the_librarys_text(self):
        self.refuses(-7, self.character.perceive, flinch.Threat([numpy.nan, 0, 0], [1, 0, 0]))
        self.refuses(-8, self.character.update, -1)
        self.refuses(-6, self.character.respond, 9999, 0.5)
        self.refuses(-10, self.character.place, 1e9, 0)
        self.refuses(-17, self.character.push, "chest", [1, 0, 0])
        self.refuses(-21, flinch.Library.from_bytes, b"")
        data = bytearray(SELECTOR.read_bytes())
        data[len(data) // 2] ^= 1
        self.refuses(-23, flinch.Library.from_bytes, bytes(data))

    def test_a_file_that_cannot_be_used_has_the_programs_text(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder, "file")
            for content in (b"", b"HIERARCHY\nROOT Hips\n", SELECTOR.read_bytes()[:-9], None):
                file.unlink(missing_ok=True)
                if content is not None:
                    file.write_bytes(content)
                said = subprocess.run([os.environ["FLINCH"], "select", str(file), "--target", "head"],
                                      capture_output=True, text=True, check=False).stderr
                with self.assertRaises(flinch.Error) as caught:
                    flinch.Library(file)
                self.assertEqual(f"flinch: {caught.exception}\n", said)

    def test_arguments_of_another_shape_are_refused(self):
        with self.assertRaisesRegex(ValueError, r"position must have the shape \(3,\), but has \(2,\)"):
            flinch.Threat([1, 2], [1, 2, 3])
        with self.assertRaisesRegex(ValueError, r"facing must have the shape \(2,\)"):
            flinch.Crowd(self.library, 2).place(numpy.zeros((2, 2)), [0], [0, 0])
        with self.assertRaisesRegex(ValueError, "there is no target elbow; it is one of head, trunk"):
            self.character.perceive_known(BALL, "elbow", 1)


unittest.main()
