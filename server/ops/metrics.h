// Takes what the server's threads count; gives it in the text format of Prometheus.
#pragma once

#include "server/lobby/lobby.h"
#include "server/net/net_stats.h"
#include "server/store/threaded_committer.h"

#include <prometheus/counter.h>
#include <prometheus/histogram.h>
#include <string>

namespace billiards::server {

/// What the store's thread measures; any thread may observe and read.
class CommitMetrics {
  public:
    CommitMetrics();

    void observe(const CommitMeasured& measured);

  private:
    friend std::string metrics_text(const NetStats&, const LobbyStats&, const CommitMetrics&);

    prometheus::Histogram took_s_;
    prometheus::Histogram submissions_;
    prometheus::Counter failed_;
};

std::string metrics_text(const NetStats& net, const LobbyStats& lobby,
                         const CommitMetrics& commits);

}  // namespace billiards::server
