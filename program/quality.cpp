// SPDX-License-Identifier: MIT
#include "program/quality.h"

#include "database/quality/quality.h"
#include "program/table.h"

namespace flinch::program {

namespace {

using enum Table::Align;

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list.empty() ? "-" : list;
}

Json measures(const database::ClipQuality& quality) {
  return {{"limit_excess_deg", shortest(quality.limit_excess_deg)},
          {"limit_joint", quality.limit_joint},
          {"hand_clearance_m", shortest(quality.hand_clearance_m)},
          {"support_drift_m", shortest(quality.support_drift_m)},
          {"foot_below_ground_m", shortest(quality.foot_below_ground_m)},
          {"balance_margin_m", shortest(quality.balance_margin_m)},
          {"speed_share", shortest(quality.speed_share)},
          {"speed_joint", quality.speed_joint},
          {"peak_acceleration_mps2", shortest(quality.peak_acceleration_mps2)}};
}

}  // namespace

std::string quality_text(const database::ClipLibrary& library) {
  Table table({{"clip"},
               {"beyond joint limits, deg", right},
               {"hands clear by, mm", right},
               {"support slips, mm", right},
               {"foot below ground, mm", right},
               {"balance margin, mm", right},
               {"joint speed / human", right},
               {"acceleration, m/s2", right},
               {"breaks"}});
  std::size_t good = 0;
  const std::vector<database::ClipQuality> all = database::measure_quality(library);
  for (const database::ClipQuality& quality : all) {
    const std::vector<std::string> broken = database::broken_bounds(quality);
    good += broken.empty() ? 1U : 0U;
    table.add({quality.name, fixed(double{quality.limit_excess_deg}, 1),
               fixed(1000 * double{quality.hand_clearance_m}, 0),
               fixed(1000 * double{quality.support_drift_m}, 1),
               fixed(1000 * double{quality.foot_below_ground_m}, 1),
               fixed(1000 * double{quality.balance_margin_m}, 0),
               fixed(double{quality.speed_share}, 2),
               fixed(double{quality.peak_acceleration_mps2}, 0), listed(broken)});
  }
  return table.text() + "\n" + std::to_string(good) + " of " + std::to_string(all.size()) +
         " clips meet all bounds\n";
}

Json quality_document(const database::ClipLibrary& library) {
  const database::QualityBounds bounds;
  Json clips = Json::array();
  for (const database::ClipQuality& quality : database::measure_quality(library)) {
    Json clip{{"name", quality.name}};
    clip.update(measures(quality));
    clip["breaks"] = database::broken_bounds(quality);
    clips.push_back(clip);
  }
  return {{"bounds",
           {{"limit_excess_deg", shortest(bounds.limit_excess_deg)},
            {"hand_clearance_m", shortest(bounds.hand_clearance_m)},
            {"support_drift_m", shortest(bounds.support_drift_m)},
            {"foot_below_ground_m", shortest(bounds.foot_below_ground_m)},
            {"balance_margin_m", shortest(bounds.balance_margin_m)},
            {"speed_share", shortest(bounds.speed_share)},
            {"peak_acceleration_mps2", shortest(bounds.peak_acceleration_mps2)}}},
          {"clips", clips}};
}

}  // namespace flinch::program
