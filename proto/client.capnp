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
}

struct CreateTable {
  name @0 :Text;
  settings @1 :Match.Settings;
  role @2 :Role;
}

struct Join {
  table @0 :UInt32;
  role @1 :Role;
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
  }
}
