// Takes a term of the rules; gives what people call it.
#include "client/app/rule_words.h"

namespace billiards::client {

std::string words(rules::Foul foul) {
    switch (foul) {
        case rules::Foul::Scratch:
            return "scratch";
        case rules::Foul::NoBallHit:
            return "no ball hit";
        case rules::Foul::WrongBallFirst:
            return "wrong ball first";
        case rules::Foul::NoCushionAfterContact:
            return "no cushion after contact";
        case rules::Foul::BallOffTable:
            return "ball off the table";
        case rules::Foul::IllegalBreak:
            return "illegal break";
        case rules::Foul::HeadString:
            return "not across the head string";
        case rules::Foul::Clock:
            return "out of time";
        case rules::Foul::BadPlacement:
            return "cue ball badly placed";
        case rules::Foul::WrongBallStruck:
            return "wrong ball struck";
        case rules::Foul::BreakingFoul:
            return "breaking foul";
    }
    return "";
}

std::string words(rules::Choice choice) {
    switch (choice) {
        case rules::Choice::Accept:
            return "play on";
        case rules::Choice::RebreakSelf:
            return "re-rack and break";
        case rules::Choice::RebreakOpponent:
            return "have the opponent break again";
        case rules::Choice::SpotEight:
            return "spot the 8 and play on";
        case rules::Choice::BallInHandBehindHeadString:
            return "take ball in hand behind the head string";
        case rules::Choice::Play:
            return "play on";
        case rules::Choice::PassBack:
            return "have the opponent play on";
    }
    return "";
}

std::string words(rules::Group group) {
    switch (group) {
        case rules::Group::Solids:
            return "solids";
        case rules::Group::Stripes:
            return "stripes";
    }
    return "";
}

}  // namespace billiards::client
