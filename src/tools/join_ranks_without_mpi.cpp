#include "tools/ranks_alone.h"

namespace hexapod {

std::unique_ptr<Ranks> joinRanks(int&, char**&) { return std::make_unique<RankAlone>(); }

}  // namespace hexapod
