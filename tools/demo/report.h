// Takes what happens to one player or spectator; gives a line of text, or of JSON, for each.
#pragma once

#include "client/net/server_link.h"
#include "tools/player/headless_player.h"
#include "tools/player/run_player.h"

#include <iosfwd>

namespace billiards::tools {

/// Lines of JSON are objects with `event`: seated, shot, moved, over, refused, link-lost,
/// and at the end result; each with `text`, the sentence for people. As text, those sentences.
class Report {
  public:
    Report(std::ostream& out, bool json) : out_(out), json_(json) {}

    PlayerEvents events();
    void link_lost(const client::LinkLost& lost);
    void result(const PlayedOut& played);

  private:
    void seated(const client::TableView& table);
    void shot(const client::TableView& before, const protocol::server::ShotPlayed& shot);
    void moved(const client::TableView& before, const protocol::server::MatchMoved& moved);
    void over(const client::TableView& before, const protocol::server::MatchOver& over);
    void refused(const protocol::server::Refused& refused);

    std::ostream& out_;
    bool json_;
};

}  // namespace billiards::tools
