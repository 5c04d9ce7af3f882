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
  turn @2 :UInt32;    # Of takeShot, choose and timeout.
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
  }
}

struct StoredSettings {
  settings @0 :Match.Settings;
  seed @1 :UInt64;
}
