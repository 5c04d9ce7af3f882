# Gives what the journal of a match keeps beside the verdicts, layouts and records of match.capnp
# and model.capnp. Ordinals are only appended.
@0x90853f82dde1fed7;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("billiards::wire");

using Model = import "model.capnp";
using Match = import "match.capnp";

struct Command {
  seat @0 :Model.Seat;
  shotId @1 :UInt64;  # Of takeShot.
  turn @2 :UInt32;    # Of the commands that name theirs.
  union {
    placeCueBall :group {
      xM @3 :Float64;
      yM @4 :Float64;
    }
    takeShot :group {
      shot @5 :Model.Shot;
      call @6 :Model.Call;
    }
    choose @7 :Match.Choice;
    timeout @8 :Void;
    concede @9 :Void;
    extend @10 :Void;
    offer @11 :Match.OfferKind;
    answer @12 :Bool;  # Whether the offer is accepted.
    claimStalemate @13 :Void;
    spotNearest @14 :Void;
    placeBall :group {
      ball @15 :UInt8;
      xM @16 :Float64;
      yM @17 :Float64;
    }
    undo @18 :Void;
    repeat @19 :Void;
    rerack @20 :Void;
    forfeit @21 :Void;
  }
}

struct StoredSettings {
  settings @0 :Match.Settings;
  seed @1 :UInt64;
}
