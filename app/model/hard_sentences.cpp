#include "app/model/hard_sentences.h"

#include "app/model/sentences.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

class Values
{
public:
    explicit Values(const sim::Error &error) : m_error(error) {}
    QString operator[](const char *name) const
    {
        const auto found = m_error.values().find(name);
        return found == m_error.values().end() ? QString() : QString::fromStdString(found->second);
    }

private:
    const sim::Error &m_error;
};

/// Why a case is not claimed; empty for any other id.
QString claimSentence(const std::string &id, const Values &value)
{
    if (id == "claim-one-by-one")
        return Text::tr("It moves one thing after the other, so pulls between them do not cancel out.");
    if (id == "claim-no-room")
        return Text::tr(
            "It looks for the moment in which a body is free of all walls, and here there is none.");
    if (id == "claim-too-many-steps")
        return Text::tr("It would need about %1 steps a frame, and gives up at %2.")
            .arg(value["steps"], value["most"]);
    if (id == "claim-adds-up")
        return Text::tr("Nothing damps, so what its steps are off adds up: to %1 px in %2 frames at worst.")
            .arg(value["off"], value["frames"]);
    if (id == "claim-stirs")
        return Text::tr("Steps that may be %1 px off keep it stirring by up to %2 px a frame.")
            .arg(value["tolerance"], value["stirred"]);
    if (id == "claim-grows")
        return Text::tr(
                   "At a step of h %1 its stiffest spring (%2) would go from %3 px to %4 px, and farther.")
            .arg(value["h"], value["k"], value["apart"], value["left"]);
    if (id == "claim-longer-step")
        return Text::tr("Its sticks are measured by steps of h %1: at %2 they err more.")
            .arg(value["most"], value["h"]);
    if (id == "claim-rings")
        return Text::tr(
                   "At a step of h %1 its stiffest spring (%2) would swing on: of %3 px, %4 px would be left "
                   "after %5 frames.")
            .arg(value["h"], value["k"], value["apart"], value["left"], value["frames"]);
    return {};
}

/// What failed; empty for any other id.
QString failureSentence(const std::string &id, const Values &value)
{
    if (id == "hard-not-finite")
        return Text::tr("After frame %1 %2 is nowhere any more: \"%3\" gave a number without an end.")
            .arg(value["frame"], bodyTitle(value["body"]), phrase(value["phase"].toStdString()));
    if (id == "hard-too-many-steps")
        return Text::tr("After frame %1 it needs more steps for a frame than it may take.")
            .arg(value["frame"]);
    if (id == "hard-too-far")
        return Text::tr("At frame %1 %2 is more than %3 px away.")
            .arg(value["frame"], bodyTitle(value["body"]), value["reach"]);
    if (id == "hard-drifts")
        return Text::tr("At frame %1 the middle of all has gone %2 px, and nothing pushed it.")
            .arg(value["frame"], value["drift"]);
    if (id == "hard-stick")
        return Text::tr("At frame %1 the stick between %2 and %3 is %4 px wrong, and %5 px are possible.")
            .arg(value["frame"], bodyTitle(value["a"]), bodyTitle(value["b"]), value["error"], value["most"]);
    if (id == "hard-moves")
        return Text::tr("In the end %1 still goes %2 px a frame.")
            .arg(bodyTitle(value["body"]), value["speed"]);
    if (id == "hard-elsewhere")
        return Text::tr("In the end %1 is %2 px from where it should rest.")
            .arg(bodyTitle(value["body"]), value["off"]);
    if (id == "hard-length")
        return Text::tr("In the end the distance of %1 and %2 is %3 px wrong.")
            .arg(bodyTitle(value["a"]), bodyTitle(value["b"]), value["off"]);
    if (id == "hard-not-the-same")
        return Text::tr("A second run differs from the first at frame %1.").arg(value["frame"]);
    if (id == "hard-not-refused")
        return Text::tr("It should be refused, and is not.");
    if (id == "hard-does-not-end")
        return Text::tr("It should end with a word about what is not finite, and does not.");
    return {};
}

}

QString hardSentence(const sim::Error &error)
{
    const Values value(error);
    const QString claim = claimSentence(error.id(), value);
    return claim.isEmpty() ? failureSentence(error.id(), value) : claim;
}

}
