// Gives the table of which client message has a place in which phase of a session.
#include "server/session/phase.h"

#include <array>
#include <type_traits>
#include <variant>

namespace billiards::server {
namespace {

namespace client = protocol::client;

struct Row {
    std::string_view name;
    std::array<bool, 5> legal;  ///< In the order of Phase.
};

template <class Message>
constexpr std::type_identity<Message> kAbout{};

constexpr bool o = false;
constexpr bool X = true;

// A new message does not compile until it has its row.
// clang-format off
//                                                                                         Greeting
//                                                                                         |  Entering
//                                                                                         |  |  Lobby
//                                                                                         |  |  |  Watching
//                                                                                         |  |  |  |  Seated
constexpr Row row(std::type_identity<client::Hello>)          { return {"Hello",          {X, o, o, o, o}}; }
constexpr Row row(std::type_identity<client::ListTables>)     { return {"ListTables",     {o, o, X, X, X}}; }
constexpr Row row(std::type_identity<client::CreateTable>)    { return {"CreateTable",    {o, o, X, o, o}}; }
constexpr Row row(std::type_identity<client::Join>)           { return {"Join",           {o, o, X, o, o}}; }
constexpr Row row(std::type_identity<client::Leave>)          { return {"Leave",          {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::Ready>)          { return {"Ready",          {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::PlaceCueBall>)   { return {"PlaceCueBall",   {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Aim>)            { return {"Aim",            {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::TakeShot>)       { return {"TakeShot",       {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Seen>)           { return {"Seen",           {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::Choose>)         { return {"Choose",         {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Concede>)        { return {"Concede",        {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Chat>)           { return {"Chat",           {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::Ping>)           { return {"Ping",           {o, o, X, X, X}}; }
constexpr Row row(std::type_identity<client::FollowTables>)   { return {"FollowTables",   {o, o, X, o, o}}; }
constexpr Row row(std::type_identity<client::QuickMatch>)     { return {"QuickMatch",     {o, o, X, o, o}}; }
constexpr Row row(std::type_identity<client::ChangeTable>)    { return {"ChangeTable",    {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::MakeInvite>)     { return {"MakeInvite",     {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::RevokeInvites>)  { return {"RevokeInvites",  {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::Kick>)           { return {"Kick",           {o, o, o, X, X}}; }
constexpr Row row(std::type_identity<client::Rematch>)        { return {"Rematch",        {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::ClaimMatch>)     { return {"ClaimMatch",     {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Extend>)         { return {"Extend",         {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Offer>)          { return {"Offer",          {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Answer>)         { return {"Answer",         {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::ClaimStalemate>) { return {"ClaimStalemate", {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::SpotNearest>)    { return {"SpotNearest",    {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::PlaceBall>)      { return {"PlaceBall",      {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Undo>)           { return {"Undo",           {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Repeat>)         { return {"Repeat",         {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::Rerack>)         { return {"Rerack",         {o, o, o, o, X}}; }
constexpr Row row(std::type_identity<client::AskHistory>)     { return {"AskHistory",     {o, o, X, X, X}}; }
constexpr Row row(std::type_identity<client::AskRecord>)      { return {"AskRecord",      {o, o, X, X, X}}; }
constexpr Row row(std::type_identity<client::AskReplay>)      { return {"AskReplay",      {o, o, X, X, X}}; }
// clang-format on

Row row_of(const protocol::ClientMessageBody& message) {
    return std::visit([]<class Message>(const Message&) { return row(kAbout<Message>); }, message);
}

}  // namespace

bool is_legal(Phase phase, const protocol::ClientMessageBody& message) {
    return row_of(message).legal.at(static_cast<std::size_t>(phase));
}

std::string_view name_of(Phase phase) {
    constexpr std::array<std::string_view, 5> kNames{"Greeting", "Entering", "Lobby", "Watching",
                                                     "Seated"};
    return kNames.at(static_cast<std::size_t>(phase));
}

std::string_view name_of(const protocol::ClientMessageBody& message) {
    return row_of(message).name;
}

}  // namespace billiards::server
