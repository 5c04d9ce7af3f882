// Gives the way from the game to the disk and back: writes in, an answer when they are durable.
#pragma once

#include "common/base/time.h"
#include "server/store/match_store.h"

#include <functional>
#include <vector>

namespace billiards::server {

struct Committed {
    StoreResult<base::Done> result;
    base::Duration took{};  ///< From submit to durable.
};

class Committer {
  public:
    using Done = std::function<void(const Committed&)>;

    virtual ~Committer() = default;

    /// Commits the writes together, after all submitted before. `done` is called later, on the
    /// thread that submitted, in the order of submission; never from within submit.
    virtual void submit(std::vector<Write> writes, Done done) = 0;
};

}  // namespace billiards::server
