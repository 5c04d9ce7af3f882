# Gives the settings, the rulings and the state of a match as they travel. Ordinals are only
# appended.
@0xf80cfb8ef51c230a;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("billiards::wire");

using Model = import "model.capnp";

enum Game { eightBall @0; nineBall @1; tenBall @2; straightPool @3; practice @4; }
enum Group { solids @0; stripes @1; }
enum Phase { break @0; open @1; groups @2; afterBreak @3; }
enum Zone { none @0; anywhere @1; behindHeadString @2; }

enum Foul {
  scratch @0;
  noBallHit @1;
  wrongBallFirst @2;
  noCushionAfterContact @3;
  ballOffTable @4;
  illegalBreak @5;
  headString @6;
  clock @7;
  badPlacement @8;
  wrongBallStruck @9;
  breakingFoul @10;
}

enum Choice {
  accept @0;
  rebreakSelf @1;
  rebreakOpponent @2;
  spotEight @3;
  ballInHandBehindHeadString @4;
  play @5;
  passBack @6;
}

enum Rerack { none @0; fourteen @1; fifteen @2; }

enum Reason {
  legalPot @0;
  breakPot @1;
  legalBreak @2;
  nothingPotted @3;
  notCalled @4;
  safety @5;
  foul @6;
  illegalBreak @7;
  breakFoul @8;
  eightOnBreak @9;
  eightOnFoulBreak @10;
  eightWon @11;
  eightWithFoul @12;
  eightEarly @13;
  eightUncalled @14;
  eightOffTable @15;
  clockRanOut @16;
  threeFouls @17;
  pushOut @18;
  nineWon @19;
  tenWon @20;
  tenEarly @21;
  uncalledPot @22;
  breakingFoul @23;
  targetReached @24;
  practice @25;
}

enum BreakOrder { alternate @0; winner @1; loser @2; }
enum PhysicsPreset { realistic @0; classic @1; }
enum Stage { shooting @0; choosing @1; over @2; }
enum OfferKind { stalemate @0; draw @1; }

enum RefusalCode {
  badSettings @0;
  matchOver @1;
  notYourTurn @2;
  staleTurn @3;
  wrongStage @4;
  notInHand @5;
  cueBallNotPlaced @6;
  badPlacement @7;
  badShot @8;
  badCall @9;
  badChoice @10;
  unsolvable @11;
  badOutcome @12;
  noExtension @13;
  badOffer @14;
  noOffer @15;
  badClaim @16;
  notSpottable @17;
  wrongGame @18;
  nothingToUndo @19;
}

struct Settings {
  game @0 :Game;
  call @1 :Bool;
  table @2 :Model.TableSize;
  physics @3 :PhysicsPreset;
  breakOrder @4 :BreakOrder;
  raceTo @5 :Int32;
  shotClockS @6 :Float64;  # 0: no clock.
  breakShotClockS @7 :Float64;
  nineOnFootSpot @8 :Bool;
  tenWinsAnyTime @9 :Bool;
  targetPoints @10 :Int32 = 100;
  extensionS @11 :Float64 = 30;  # 0: none.
  aimHelp @12 :Bool = true;
  spectatorDelayS @13 :Float64;
}

struct RackState {
  phase @0 :Phase;
  shooter @1 :Model.Seat;
  groups :union {
    none @2 :Void;
    set :group {
      first @3 :Group;
      second @4 :Group;
    }
  }
  onTable @5 :UInt32;  # Sets of balls: bit n stands for ball n.
  inHand @6 :Zone;
  behindHeadString @7 :UInt32;
  consecutiveFouls :group {
    first @8 :UInt32;
    second @9 :UInt32;
  }
  pushOutAllowed @10 :Bool;
  scores :group {
    first @11 :Int32;
    second @12 :Int32;
  }
}

struct Verdict {
  fouls @0 :List(Foul);  # Ascending, each once.
  turnContinues @1 :Bool;
  nextPlayer @2 :Model.Seat;
  inHand @3 :Zone;
  choices @4 :List(Choice);
  chooser :union {
    none @5 :Void;
    seat @6 :Model.Seat;
  }
  groups :union {
    none @7 :Void;
    set :group {
      first @8 :Group;
      second @9 :Group;
    }
  }
  spotted @10 :List(UInt8);  # Balls in ascending number.
  winner :union {
    none @11 :Void;
    seat @12 :Model.Seat;
  }
  consecutiveFouls :group {
    first @13 :UInt32;
    second @14 :UInt32;
  }
  reason @15 :Reason;
  phase @16 :Phase = open;
  scoreChange :group {
    first @17 :Int32;
    second @18 :Int32;
  }
  rerack @19 :Rerack;
}

struct MatchState {
  # Without the seed, which tells of racks to come, and the earlier positions of practice.
  settings @0 :Settings;
  stage @1 :Stage;
  turn @2 :UInt32;
  toAct @3 :Model.Seat;
  rackNumber @4 :UInt32;
  breaker @5 :Model.Seat;
  racksWon :group {
    first @6 :UInt32;
    second @7 :UInt32;
  }
  shotsPlayed @8 :UInt32;
  rack @9 :RackState;
  layout @10 :Model.Layout;
  pending :union {
    none @11 :Void;
    choice :group {
      verdict @12 :Verdict;
      before @13 :RackState;
    }
  }
  winner :union {
    none @14 :Void;
    seat @15 :Model.Seat;
  }
  extendedIn :group {  # Turns; 0: none.
    first @16 :UInt32;
    second @17 :UInt32;
  }
  offer :union {
    none @18 :Void;
    made :group {
      kind @19 :OfferKind;
      by @20 :Model.Seat;
    }
  }
  claim :union {
    none @21 :Void;
    turns :group {
      first @22 :UInt32;
      second @23 :UInt32;
    }
  }
}
