# Gives everything that a client may say. Ordinals are only appended.
@0xe9a3485c3a7824bd;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("billiards::wire");

using Model = import "model.capnp";
using Match = import "match.capnp";

enum Role { player @0; spectator @1; bothSeats @2; }

struct Hello {
  name @0 :Text;
  token @1 :Data;  # 32 bytes, or none.
  followed :union {
    none @2 :Void;
    table :group {
      id @3 :UInt32;
      stream @4 :UInt64;
      sequence @5 :UInt64;
    }
  }
}

struct CreateTable {
  name @0 :Text;
  settings @1 :Match.Settings;
  role @2 :Role;
  isPrivate @3 :Bool;
  passcode @4 :Text;
}

struct Join {
  table @0 :UInt32;
  role @1 :Role;
  invite @2 :Data;  # 16 bytes, or none.
  passcode @3 :Text;
}

struct QuickMatch {
  game @0 :Match.Game;
}

struct ChangeTable {
  settings @0 :Match.Settings;
  isPrivate @1 :Bool;
  passcode :union {
    keep @2 :Void;
    text @3 :Text;
  }
}

struct MakeInvite {
  role @0 :Role;
}

struct Kick {
  name @0 :Text;
}

struct PlaceCueBall {
  turn @0 :UInt32;
  xM @1 :Float64;
  yM @2 :Float64;
}

struct Aim {
  turn @0 :UInt32;
  shot @1 :Model.Shot;
}

struct TakeShot {
  turn @0 :UInt32;
  shotId @1 :UInt64;
  shot @2 :Model.Shot;
  call @3 :Model.Call;
}

struct Seen {
  sequence @0 :UInt64;
}

struct Choose {
  turn @0 :UInt32;
  choice @1 :Match.Choice;
}

struct OfTurn {
  # All that some requests say.
  turn @0 :UInt32;
}

struct Offer {
  turn @0 :UInt32;
  kind @1 :Match.OfferKind;
}

struct Answer {
  turn @0 :UInt32;
  accept @1 :Bool;
}

struct PlaceBall {
  ball @0 :UInt8;
  xM @1 :Float64;
  yM @2 :Float64;
}

struct AskHistory {
  player @0 :Text;
  before @1 :UInt64;
}

struct AskRecord {
  player @0 :Text;
}

struct AskReplay {
  match @0 :UInt64;
  first @1 :UInt64;
}

struct Chat {
  text @0 :Text;
}

struct Ping {
  clientTimeUs @0 :Int64;
}

struct ClientMessage {
  requestId @0 :UInt32;
  union {
    hello @1 :Hello;
    listTables @2 :Void;
    createTable @3 :CreateTable;
    join @4 :Join;
    leave @5 :Void;
    ready @6 :Void;
    placeCueBall @7 :PlaceCueBall;
    aim @8 :Aim;
    takeShot @9 :TakeShot;
    seen @10 :Seen;
    choose @11 :Choose;
    concede @12 :Void;
    chat @13 :Chat;
    ping @14 :Ping;
    quickMatch @15 :QuickMatch;
    changeTable @16 :ChangeTable;
    makeInvite @17 :MakeInvite;
    revokeInvites @18 :Void;
    kick @19 :Kick;
    rematch @20 :Void;
    extend @21 :OfTurn;
    offer @22 :Offer;
    answer @23 :Answer;
    claimStalemate @24 :OfTurn;
    spotNearest @25 :OfTurn;
    claimMatch @26 :Void;
    placeBall @27 :PlaceBall;
    undo @28 :Void;
    repeat @29 :Void;
    rerack @30 :Void;
    askHistory @31 :AskHistory;
    askRecord @32 :AskRecord;
    askReplay @33 :AskReplay;
    followTables @34 :Void;
  }
}
