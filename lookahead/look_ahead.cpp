// SPDX-License-Identifier: MIT
#include "lookahead/look_ahead.h"

#include <algorithm>
#include <cmath>

#include "lookahead/response_trial.h"
#include "models/selector.h"
#include "runtime/response/prepared_library.h"

namespace flinch::lookahead {

using runtime::Perception;
using runtime::Status;

namespace {

// How long training simulates after the predicted impact (train::SimulationPlan::tail_s).
constexpr double kTail_s = 0.3;

/// From where the character answers, as the table of work has it.
models::ResponseStart start_of(const runtime::PreparedLibrary& library,
                               const features::Scenario& scenario) {
  const features::CharacterState& state = scenario.state;
  const float period_s = library.stance_of(state).loop.period_s();
  const float time_s = scenario.time_to_impact_s;
  return {state.stance, period_s > 0 ? (state.idle_time_s + time_s) / period_s : 0, time_s};
}

bool is_over(const Budget& budget, double end_us) {
  return budget.now_us != nullptr && !(budget.now_us(budget.clock) < end_us);
}

bool is_cheaper(const ForeseenCandidate& candidate, const ForeseenCandidate& best) {
  return candidate.cost_ns < best.cost_ns ||
         (candidate.cost_ns == best.cost_ns && candidate.work_j < best.work_j);
}

/// Whether a candidate's whole cost is known.
bool is_known(const ForeseenCandidate& candidate) {
  return candidate.foreseen == Foreseen::misses || candidate.foreseen == Foreseen::simulated;
}

bool is_more_urgent(const Perception& first, const Perception& second) {
  return first.scenario.time_to_impact_s < second.scenario.time_to_impact_s;
}

}  // namespace

struct LookAheadWorkspace::Memory {
  Memory(const runtime::Library& searched, std::shared_ptr<const LookAheadData> shared)
      : library(&searched),
        data(std::move(shared)),
        trial(*data->figure, double{searched.prepared().reach_m}) {}

  const runtime::Library* library;
  std::shared_ptr<const LookAheadData> data;
  runtime::Workspace selection;
  ResponseTrial trial;
};

LookAheadWorkspace::LookAheadWorkspace() noexcept = default;
LookAheadWorkspace::~LookAheadWorkspace() = default;
LookAheadWorkspace::LookAheadWorkspace(LookAheadWorkspace&&) noexcept = default;
LookAheadWorkspace& LookAheadWorkspace::operator=(LookAheadWorkspace&&) noexcept = default;

const char* name_of(Foreseen foreseen) noexcept {
  switch (foreseen) {
    case Foreseen::nothing:
      return "nothing";
    case Foreseen::costlier:
      return "costlier";
    case Foreseen::misses:
      return "misses";
    case Foreseen::simulated:
      return "simulated";
    case Foreseen::cut:
      return "cut";
  }
  return "unknown";
}

std::shared_ptr<const LookAheadData> make_look_ahead_data(const runtime::Library& library) noexcept
    try {
  if (!library.is_loaded() || !library.selector().costs) return nullptr;
  return std::make_shared<const LookAheadData>(
      LookAheadData{std::make_shared<const sim::FigureModel>(library.clip_library().character)});
} catch (...) {
  return nullptr;
}

bool LookAheadWorkspace::reserve_memory(const runtime::Library& library,
                                        std::shared_ptr<const LookAheadData> data) noexcept try {
  if (!data || !library.is_loaded() || !library.selector().costs) return false;
  auto memory = std::make_unique<Memory>(library, std::move(data));
  if (memory->selection.reserve_memory(library.selection_bytes()) != database::LoadStatus::ok)
    return false;
  memory_ = std::move(memory);
  return true;
} catch (...) {
  return false;
}

bool LookAheadWorkspace::is_for(const runtime::Library& library) const noexcept {
  return memory_ && memory_->library == &library;
}

Search::Search(const runtime::Library& library) noexcept : character_(library) {}

Status Search::begin(runtime::Character& character, std::span<const features::Threat> threats,
                     int candidates, LookAheadWorkspace& workspace) noexcept {
  if (!character.library().is_loaded()) return Status::not_loaded;
  if (!workspace.is_for(character.library())) return Status::other_workspace;
  std::array<Perception, kMaxThreats> urgent{};
  const runtime::Notice noticed = character.notice(threats, urgent);
  if (noticed.count == 0) {
    if (noticed.status == Status::misses || noticed.status == Status::unnoticed) {
      is_open_ = false;
      status_ = {};
      status_.status = noticed.status;
    }
    return noticed.status;
  }
  const Status status =
      begin(character, std::span(urgent).first(noticed.count), candidates, workspace);
  status_.ignored = noticed.ignored;
  return status;
}

Status Search::begin(const runtime::Character& character, std::span<const Perception> threats,
                     int candidates, LookAheadWorkspace& workspace) noexcept {
  const Status status = open(character, threats, workspace);
  if (status == Status::ok) rank(candidates, workspace);
  return status;
}

Status Search::begin(const runtime::Character& character, std::span<const Perception> threats,
                     std::span<const models::Candidate> candidates,
                     LookAheadWorkspace& workspace) noexcept {
  const auto clips = static_cast<int>(
      character.library().is_loaded() ? character.library().clip_library().clips.size() : 0);
  const bool are_clips =
      !candidates.empty() &&
      std::ranges::all_of(candidates, [clips](const models::Candidate& candidate) {
        return candidate.clip >= 0 && candidate.clip < clips;
      });
  if (clips > 0 && !are_clips) return Status::bad_clip;
  const Status status = open(character, threats, workspace);
  if (status != Status::ok) return status;
  status_.count = std::min(candidates.size(), kMaxCandidates);
  for (std::size_t i = 0; i < status_.count; ++i) status_.candidates[i].candidate = candidates[i];
  return status;
}

/// Starts a search without candidates.
Status Search::open(const runtime::Character& character, std::span<const Perception> threats,
                    const LookAheadWorkspace& workspace) noexcept {
  if (!character.library().is_loaded()) return Status::not_loaded;
  if (!workspace.is_for(character.library())) return Status::other_workspace;
  const auto is_usable = [](const Perception& threat) {
    const float time_s = threat.scenario.time_to_impact_s;
    return features::is_usable(threat.scenario.threat) && time_s > 0 &&
           time_s <= features::kMaxHorizon_s && threat.delay_s >= 0;
  };
  if (threats.empty() || threats.size() > kMaxThreats || !std::ranges::all_of(threats, is_usable))
    return Status::bad_threat;
  status_ = {};
  status_.status = Status::ok;
  status_.threats = threats.size();
  auto end = threats_.begin();
  for (const Perception& threat : threats) {  // an insertion sort, since stable_sort allocates
    *end = threat;
    const auto at = std::upper_bound(threats_.begin(), end, threat, is_more_urgent);
    std::rotate(at, end, end + 1);
    ++end;
  }
  character_ = character;
  next_ = 0;
  elapsed_s_ = latest_begin_s_ = 0;
  is_open_ = true;
  return Status::ok;
}

/// Takes the threats' best clips in turn, each clip once, until there are as many as wanted.
void Search::rank(int candidates, LookAheadWorkspace& workspace) noexcept {
  const auto wanted =
      static_cast<std::size_t>(std::clamp(candidates, 1, static_cast<int>(kMaxCandidates)));
  std::array<std::array<models::Candidate, kMaxCandidates>, kMaxThreats> best{};
  std::array<std::size_t, kMaxThreats> count{};
  for (std::size_t i = 0; i < status_.threats; ++i) {
    character_.rank(threats_[i], workspace.memory_->selection, std::span(best[i]).first(wanted),
                    count[i]);
  }
  for (std::size_t place = 0; place < wanted; ++place) {
    for (std::size_t i = 0; i < status_.threats && status_.count < wanted; ++i) {
      if (place >= count[i]) continue;
      const auto listed = std::span(status_.candidates).first(status_.count);
      const bool is_listed = std::ranges::any_of(listed, [&](const ForeseenCandidate& other) {
        return other.candidate.clip == best[i][place].clip;
      });
      if (!is_listed) status_.candidates[status_.count++].candidate = best[i][place];
    }
  }
}

/// Returns false if the budget ended before all that is to be known was known.
bool Search::try_candidate(ForeseenCandidate& candidate, const Budget& budget, double end_us,
                           LookAheadWorkspace& workspace) noexcept {
  const runtime::Library& library = *workspace.memory_->library;
  const models::ResponseCosts& costs = *library.selector().costs;
  const double brawn = library.selector().brawn;
  const Perception& urgent = threats_[0];
  const int clip = candidate.candidate.clip;
  const ForeseenCandidate best = status_.candidates[status_.chosen];
  const double limit_ns =
      is_known(best) ? double{best.cost_ns} : std::numeric_limits<double>::infinity();
  candidate.work_j = work_j(costs, clip, start_of(library.prepared(), urgent.scenario));
  const double work_j = double{candidate.work_j};
  // Of several threats, the one that is met says what work counts.
  const int kind = urgent.scenario.threat.kind;
  const double least_ns = cost_ns(costs, brawn, kind, 0, work_j);
  if (least_ns > limit_ns) {
    candidate.foreseen = Foreseen::costlier;
    candidate.cost_ns = static_cast<float>(least_ns);
    return true;
  }
  const runtime::Response response = character_.plan(urgent, clip);
  if (!is_valid(response)) return true;
  ResponseTrial& trial = workspace.memory_->trial;
  trial.follow(response, library.clip_library().rate_hz);
  const double max_damage_ns =
      brawn < 1 ? (limit_ns - least_ns) / (1 - brawn) : std::numeric_limits<double>::infinity();
  double damage_ns = 0;
  double contact_s = std::numeric_limits<double>::infinity();
  Foreseen foreseen = Foreseen::misses;
  for (const Perception& threat : std::span(threats_).first(status_.threats)) {
    if (is_over(budget, end_us)) return false;
    const double until_s =
        double{threat.scenario.time_to_impact_s} - double{urgent.delay_s} + kTail_s;
    const features::Ball ball =
        features::ball_of(features::advanced(threat.scenario.threat, urgent.delay_s));
    const motion::PerBody<double>& vulnerability =
        vulnerability_to(costs, threat.scenario.threat.kind);
    const TrialResult result = trial.meet(ball, until_s, vulnerability, max_damage_ns - damage_ns);
    damage_ns += result.damage_ns;
    contact_s = std::min(contact_s, result.first_contact_s + double{urgent.delay_s});
    if (result.steps > 0) {
      ++status_.encounters;
      foreseen = Foreseen::simulated;
    }
    if (!result.is_cut) continue;
    foreseen = Foreseen::cut;
    break;
  }
  candidate.foreseen = foreseen;
  candidate.damage_ns = static_cast<float>(damage_ns);
  candidate.cost_ns = static_cast<float>(cost_ns(costs, brawn, kind, damage_ns, work_j));
  candidate.contact_s = static_cast<float>(contact_s);
  if (is_known(candidate) && (!is_known(best) || is_cheaper(candidate, best))) {
    status_.chosen = static_cast<std::size_t>(&candidate - status_.candidates.data());
    latest_begin_s_ = is_idle(response) ? urgent.scenario.time_to_impact_s
                                        : urgent.delay_s + response.first_motion_s;
  }
  return true;
}

bool Search::advance(const Budget& budget, LookAheadWorkspace& workspace) noexcept {
  if (!is_open_) return true;
  if (!workspace.is_for(character_.library())) return false;
  const double end_us =
      budget.now_us != nullptr ? budget.now_us(budget.clock) + budget.us : budget.us;
  // Where there is no choice, or its work is not known, there is nothing to find out.
  const models::ResponseCosts& costs = *character_.library().selector().costs;
  if (status_.count == 1 || !knows_work_from(costs, threats_[0].scenario.state.stance))
    next_ = status_.count;
  while (next_ < status_.count && !is_over(budget, end_us)) {
    if (!try_candidate(status_.candidates[next_], budget, end_us, workspace)) break;
    status_.tried = ++next_;
  }
  status_.is_complete = next_ == status_.count;
  return status_.is_complete;
}

const LookAheadStatus& Search::finish(runtime::Character& character) noexcept {
  if (!is_open_) return status_;
  is_open_ = false;
  std::array<models::Candidate, kMaxCandidates> candidates;
  for (std::size_t i = 0; i < status_.count; ++i) candidates[i] = status_.candidates[i].candidate;
  Perception perception = threats_[0];
  perception.scenario.time_to_impact_s -= elapsed_s_;
  perception.delay_s = std::max(perception.delay_s - elapsed_s_, 0.0F);
  status_.status = character.answer(perception, status_.candidates[status_.chosen].candidate.clip,
                                    std::span(candidates).first(status_.count));
  return status_;
}

Status Search::update(runtime::Character& character, float dt_s, const Budget& budget,
                      LookAheadWorkspace& workspace) noexcept {
  if (is_open_ && (advance(budget, workspace) || elapsed_s_ + dt_s > latest_begin_s_))
    finish(character);
  elapsed_s_ += dt_s;
  return character.update(dt_s);
}

namespace {

LookAheadStatus refused(Status status) {
  LookAheadStatus told;
  told.status = status;
  return told;
}

LookAheadStatus finished(Search& search, Status begun, runtime::Character& character,
                         const LookAhead& look_ahead, LookAheadWorkspace& workspace) {
  if (begun != Status::ok) return refused(begun);
  search.advance(look_ahead.budget, workspace);
  return search.finish(character);
}

}  // namespace

/// Where there is one candidate, there is no choice: answers as Character::perceive does.
LookAheadStatus Search::answer_first(runtime::Character& character, const Perception& urgent,
                                     LookAheadWorkspace& workspace) noexcept {
  LookAheadStatus status;
  std::array<models::Candidate, 1> first;
  status.status = character.rank(urgent, workspace.memory_->selection, first, status.count);
  if (status.status != Status::ok) return status;
  status.candidates[0].candidate = first[0];
  status.is_complete = true;
  status.status = character.answer(urgent, first[0].clip, first);
  return status;
}

LookAheadStatus perceive(runtime::Character& character, std::span<const features::Threat> threats,
                         const LookAhead& look_ahead, LookAheadWorkspace& workspace) noexcept {
  if (look_ahead.candidates <= 1) {
    if (!character.library().is_loaded()) return refused(Status::not_loaded);
    if (!workspace.is_for(character.library())) return refused(Status::other_workspace);
    std::array<Perception, kMaxThreats> urgent;
    const runtime::Notice noticed = character.notice(threats, urgent);
    if (noticed.count == 0) return refused(noticed.status);
    LookAheadStatus status = Search::answer_first(character, urgent[0], workspace);
    status.threats = noticed.count;
    status.ignored = noticed.ignored;
    return status;
  }
  Search search(character.library());
  const Status begun = search.begin(character, threats, look_ahead.candidates, workspace);
  return finished(search, begun, character, look_ahead, workspace);
}

LookAheadStatus perceive(runtime::Character& character, const Perception& perception,
                         const LookAhead& look_ahead, LookAheadWorkspace& workspace) noexcept {
  Search search(character.library());
  const Status begun =
      search.begin(character, std::span(&perception, 1), look_ahead.candidates, workspace);
  return finished(search, begun, character, look_ahead, workspace);
}

}  // namespace flinch::lookahead
