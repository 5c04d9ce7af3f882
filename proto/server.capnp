# Gives everything that a server may say. Ordinals are only appended.
@0xdae5e6c31cd6f44f;

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("billiards::wire");

using Model = import "model.capnp";
using Match = import "match.capnp";

enum RefusedCode {
  malformed @0;
  notInThisPhase @1;
  tooMany @2;
  greetingTimeout @3;
  idleTimeout @4;
  badName @5;
  unknownToken @6;
  unknownTable @7;
  seatTaken @8;
  tableFull @9;
  tooEarly @10;
  matchRunning @11;
  storageFailed @12;
  shuttingDown @13;
  match @14;
  notOwner @15;
  wrongSecret @16;
  notAllowed @17;
  unknownPlayer @18;
  unknownMatch @19;
  busy @20;
}

enum NoticeCode { shuttingDown @0; tableClosed @1; replacedByNewConnection @2; kicked @3; }

enum Ending { played @0; conceded @1; claimed @2; abandoned @3; }

enum Move {
  choice @0;
  timeout @1;
  concession @2;
  forfeit @3;
  extension @4;
  offer @5;
  acceptance @6;
  rejection @7;
  stalemateClaim @8;
  spotting @9;
  placing @10;
  undoing @11;
  repeating @12;
  reracking @13;
}

struct SeatView {
  taken @0 :Bool;
  connected @1 :Bool;
  ready @2 :Bool;
  name @3 :Text;
  claimable :union {
    none @4 :Void;
    us @5 :Int64;
  }
}

struct TableRow {
  table @0 :UInt32;
  name @1 :Text;
  settings @2 :Match.Settings;
  firstSeat @3 :SeatView;
  secondSeat @4 :SeatView;
  racksWon :group {
    first @5 :UInt32;
    second @6 :UInt32;
  }
  playing @7 :Bool;
  spectators @8 :UInt32;
  isPrivate @9 :Bool;
  hasPasscode @10 :Bool;
  owner @11 :Text;
}

struct Turn {
  opensUs @0 :Int64;
  deadline :union {
    none @1 :Void;
    us @2 :Int64;
  }
}

struct Welcome {
  name @0 :Text;
  token @1 :Data;
  serverTimeUs @2 :Int64;
  table :union {
    none @3 :Void;
    id @4 :UInt32;
  }
}

struct Refused {
  code @0 :RefusedCode;
  matchCode :union {
    none @1 :Void;
    code @2 :Match.RefusalCode;
  }
  detail @3 :Text;
  inReplyTo @4 :UInt32;
}

struct TableList {
  tables @0 :List(TableRow);
}

struct ShotPlayed {
  sequence @0 :UInt64;
  struckUs @1 :Int64;
  seat @2 :Model.Seat;
  shotId @3 :UInt64;
  shot @4 :Model.Shot;
  call @5 :Model.Call;
  record @6 :Model.ShotRecord;
  verdict @7 :Match.Verdict;
  after @8 :Match.MatchState;
  turn @9 :Turn;
  commitUs @10 :UInt32;
}

struct TableSnapshot {
  sequence @0 :UInt64;
  row @1 :TableRow;
  yourSeats @2 :List(Model.Seat);
  match :union {
    none @3 :Void;
    state @4 :Match.MatchState;
  }
  rolling :union {
    none @5 :Void;
    shot @6 :ShotPlayed;
  }
  turn @7 :Turn;
  serverTimeUs @8 :Int64;
  stream @9 :UInt64;
}

struct Resumed {
  table @0 :UInt32;
  yourSeats @1 :List(Model.Seat);
  serverTimeUs @2 :Int64;
}

struct TableChanged {
  sequence @0 :UInt64;
  row @1 :TableRow;
}

struct TableListChange {
  changed @0 :List(TableRow);
  gone @1 :List(UInt32);
}

struct InviteMade {
  table @0 :UInt32;
  playing @1 :Bool;  # Otherwise for watching.
  secret @2 :Data;
  expiresUs @3 :Int64;
}

struct HistoryRow {
  match @0 :UInt64;
  endedS @1 :Int64;
  game @2 :Match.Game;
  firstName @3 :Text;
  secondName @4 :Text;
  racksWon :group {
    first @5 :UInt32;
    second @6 :UInt32;
  }
  winner :union {
    none @7 :Void;
    seat @8 :Model.Seat;
  }
  shots @9 :UInt32;
  ending @10 :Ending;
}

struct HistoryPage {
  rows @0 :List(HistoryRow);
  hasMore @1 :Bool;
}

struct PlayerRecord {
  name @0 :Text;
  games @1 :UInt32;
  wins @2 :UInt32;
  draws @3 :UInt32;
  rating @4 :Float64;
  deviation @5 :Float64;
}

struct ReplayChunk {
  match @0 :UInt64;
  first @1 :UInt64;
  total @2 :UInt64;
  messages @3 :List(Data);  # Each a ServerMessage of one segment.
}

struct SeatChanged {
  sequence @0 :UInt64;
  firstSeat @1 :SeatView;
  secondSeat @2 :SeatView;
  spectators @3 :UInt32;
}

struct MatchStarted {
  sequence @0 :UInt64;
  state @1 :Match.MatchState;
  turn @2 :Turn;
}

struct CueBallPlaced {
  sequence @0 :UInt64;
  seat @1 :Model.Seat;
  xM @2 :Float64;
  yM @3 :Float64;
}

struct AimShown {
  seat @0 :Model.Seat;
  turn @1 :UInt32;
  shot @2 :Model.Shot;
}

struct TurnOpened {
  sequence @0 :UInt64;
  number @1 :UInt32;
  turn @2 :Turn;
}

struct MatchMoved {
  sequence @0 :UInt64;
  seat @1 :Model.Seat;
  choice :union {
    none @2 :Void;
    made @3 :Match.Choice;
  }
  verdict :union {
    none @4 :Void;
    ruling @5 :Match.Verdict;
  }
  after @6 :Match.MatchState;
  turn @7 :Turn;
  move @8 :Move;
}

struct MatchOver {
  sequence @0 :UInt64;
  winner @1 :Model.Seat;
  racksWon :group {
    first @2 :UInt32;
    second @3 :UInt32;
  }
  shots @4 :UInt32;
  conceded @5 :Bool;
  undecided @6 :Bool;  # Nobody has won, whatever winner says.
  ending @7 :Ending;
}

struct ChatSaid {
  name @0 :Text;
  text @1 :Text;
}

struct Notice {
  code @0 :NoticeCode;
  detail @1 :Text;
}

struct Pong {
  clientTimeUs @0 :Int64;
  serverTimeUs @1 :Int64;
}

struct ServerMessage {
  union {
    welcome @0 :Welcome;
    refused @1 :Refused;
    tableList @2 :TableList;
    tableSnapshot @3 :TableSnapshot;
    seatChanged @4 :SeatChanged;
    matchStarted @5 :MatchStarted;
    cueBallPlaced @6 :CueBallPlaced;
    aimShown @7 :AimShown;
    shotPlayed @8 :ShotPlayed;
    turnOpened @9 :TurnOpened;
    matchMoved @10 :MatchMoved;
    matchOver @11 :MatchOver;
    chatSaid @12 :ChatSaid;
    notice @13 :Notice;
    pong @14 :Pong;
    resumed @15 :Resumed;
    tableChanged @16 :TableChanged;
    tableListChange @17 :TableListChange;
    inviteMade @18 :InviteMade;
    historyPage @19 :HistoryPage;
    playerRecord @20 :PlayerRecord;
    replayChunk @21 :ReplayChunk;
  }
}
