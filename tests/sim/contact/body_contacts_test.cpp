// SPDX-License-Identifier: MIT
#include "sim/contact/body_contacts.h"

#include <gtest/gtest.h>

#include <vector>

#include "motion/default_character.h"

namespace flinch::sim {
namespace {

using motion::Body;

class BodyContactsTest : public testing::Test {
 protected:
  FigureModel figure_model_{motion::default_character()};
  BodyContacts body_contacts_{figure_model_};
  motion::PerBody<double> impulse_;
  std::vector<double> charged_;  // for the contacts of the last step

  void step(double time_s, const std::vector<ContactImpulse>& contacts) {
    body_contacts_.begin_step(time_s);
    for (const ContactImpulse& contact : contacts) {
      if (!contact.second) body_contacts_.add_hit(contact.first);
    }
    charged_.clear();
    for (const ContactImpulse& contact : contacts)
      charged_.push_back(body_contacts_.add_impulse(contact, impulse_));
  }
};

TEST_F(BodyContactsTest, ABodyPassesOnAtMostTheImpulseItReceived) {
  step(0, {{Body::left_hand, {}, 5}, {Body::head, Body::left_hand, 8}});
  EXPECT_EQ(charged_, (std::vector<double>{5, 5}));
  EXPECT_DOUBLE_EQ(impulse_[Body::left_hand], 5 + 5);
  EXPECT_DOUBLE_EQ(impulse_[Body::head], 5);
}

TEST_F(BodyContactsTest, ImpulsePassedOnInSeveralStepsAddsUpToNoMore) {
  step(0, {{Body::left_hand, {}, 5}});
  step(0.001, {{Body::head, Body::left_hand, 2}});
  step(0.002, {{Body::chest, Body::left_hand, 2}});
  step(0.003, {{Body::abdomen, Body::left_hand, 2}});
  EXPECT_DOUBLE_EQ(impulse_[Body::head], 2);
  EXPECT_DOUBLE_EQ(impulse_[Body::chest], 2);
  EXPECT_DOUBLE_EQ(impulse_[Body::abdomen], 1);
}

TEST_F(BodyContactsTest, ABodyStruckByAnotherBodyPassesItsImpulseOn) {
  step(0, {{Body::left_hand, {}, 5},
           {Body::left_forearm, Body::left_hand, 3},
           {Body::chest, Body::left_forearm, 9}});
  EXPECT_DOUBLE_EQ(impulse_[Body::left_forearm], 3 + 3);
  EXPECT_DOUBLE_EQ(impulse_[Body::chest], 3);
}

TEST_F(BodyContactsTest, ReceivedImpulseExpiresWithTheHit) {
  step(0, {{Body::left_hand, {}, 5}});
  step(0.2, {{Body::head, Body::left_hand, 4}});
  EXPECT_DOUBLE_EQ(impulse_[Body::head], 0);
}

}  // namespace
}  // namespace flinch::sim
