# Gives balls, tables, shots and the record of a shot as they travel. Ordinals are only appended.
@0x8011207dc58a802d;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("billiards::wire");

enum Seat { first @0; second @1; }

enum TableSize { sevenFoot @0; eightFoot @1; nineFoot @2; }

enum Motion {
  resting @0;
  spinning @1;
  rolling @2;
  sliding @3;
  airborne @4;
  pocketed @5;
  offTable @6;
}

enum Place { onTable @0; inHand @1; pocketed @2; offTable @3; }

struct PlacedBall {
  ball @0 :UInt8;
  place @1 :Place;
  xM @2 :Float64;
  yM @3 :Float64;
}

struct Layout {
  balls @0 :List(PlacedBall);  # Each once, in ascending number.
}

struct Shot {
  angleRad @0 :Float64;
  power @1 :Float64;
  tipLeft @2 :Float64;  # Ball radii, like tipUp.
  tipUp @3 :Float64;
  elevationRad @4 :Float64;
}

struct Call {
  union {
    none @0 :Void;
    pot :group {
      ball @1 :UInt8;
      pocket @2 :UInt8;
    }
    safety @3 :Void;
    pushOut @4 :Void;
  }
}

struct Event {
  # Eight bytes: a break has hundreds.
  time @0 :UInt16;  # An index into ShotRecord.timesS.
  ball @1 :UInt8;
  held @2 :Bool;  # Of cushion and jaw: it was touching already.
  union {
    ballBall @3 :UInt8;  # The other ball, of the higher number.
    cushion @4 :UInt16;  # The index of the cushion segment.
    jaw @5 :UInt16;      # The index of the jaw arc.
    pocketed @6 :UInt8;  # The pocket.
    motion @7 :Motion;   # How it moves from now on.
    headString @8 :Int8;  # +1: towards +x; -1: back.
    landing @9 :Void;
    offTable @10 :Void;
  }
}

struct Track {
  # Eight bytes and the radius. Its segments are the next ones of ShotRecord.
  ball @0 :UInt8;
  segments @1 :UInt16;
  radiusM @2 :Float64;
}

struct ShotRecord {
  # Times and the final layout are exact; the segments' numbers went through 32-bit floats. The
  # hash is of the record before that. How a segment's form says which numbers follow for it, in
  # which order, and what the others are, stands in docs/protocol.md.
  hash @0 :UInt64;
  durationS @1 :Float64;
  timesS @2 :List(Float64);  # Of events and of segments' starts: ascending, each once.
  events @3 :List(Event);
  tracks @4 :List(Track);  # In ascending number of the ball.
  segmentTimes @5 :List(UInt16);  # Of each segment: an index into timesS.
  segmentForms @6 :List(UInt8);
  numbers @7 :List(Float32);  # Of all segments, one after another.
  finalLayout @8 :Layout;
}
