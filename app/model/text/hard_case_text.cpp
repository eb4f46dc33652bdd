#include "app/model/text/hard_case_text.h"

#include "app/model/text/sentences.h"

#include <QCoreApplication>

namespace app {

namespace {

struct HardCaseText
{
    Q_DECLARE_TR_FUNCTIONS(HardCaseText)
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

/// Returns why a case is not claimed, or an empty text for any other id.
QString claimSentence(const std::string &id, const Values &value)
{
    if (id == "claim-one-by-one")
        return HardCaseText::tr(
            "It moves one body after the other, so the pulls between them do not cancel.");
    if (id == "claim-no-room")
        return HardCaseText::tr(
            "It looks for the moment when a body leaves the walls, but here a body never leaves them.");
    if (id == "claim-too-many-steps")
        return HardCaseText::tr("It would need about %1 steps in a frame, but stops after %2.")
            .arg(value["steps"], value["most"]);
    if (id == "claim-adds-up")
        return HardCaseText::tr(
                   "Without damping, the errors of its steps add up: to %1 px in %2 frames at worst.")
            .arg(value["off"], value["frames"]);
    if (id == "claim-stirs")
        return HardCaseText::tr("Because its steps may have errors of %1 px, it never comes fully to rest: "
                                "it moves by up to %2 px a frame.")
            .arg(value["tolerance"], value["stirred"]);
    if (id == "claim-grows")
        return HardCaseText::tr("With a step of %1, its stiffest spring (stiffness %2) would swing from %3 "
                                "px to %4 px, and farther.")
            .arg(value["h"], value["k"], value["apart"], value["left"]);
    if (id == "claim-longer-step")
        return HardCaseText::
            tr("Its sticks are only tested with steps up to %1. With a step of %2, their errors are larger.")
                .arg(value["most"], value["h"]);
    if (id == "claim-rings")
        return HardCaseText::tr("With a step of %1, its stiffest spring (stiffness %2) would not stop "
                                "swinging: of %3 px, %4 px would be left after %5 frames.")
            .arg(value["h"], value["k"], value["apart"], value["left"], value["frames"]);
    return {};
}

/// Returns what failed, or an empty text for any other id.
QString failureSentence(const std::string &id, const Values &value)
{
    if (id == "hard-not-finite")
        return HardCaseText::
            tr("After frame %1, the position of %2 is no longer a finite number: it overflowed in \"%3\".")
                .arg(value["frame"], bodyTitle(value["body"]), phrase(value["phase"].toStdString()));
    if (id == "hard-too-many-steps")
        return HardCaseText::tr("After frame %1, the method needs more steps for one frame than allowed.")
            .arg(value["frame"]);
    if (id == "hard-too-far")
        return HardCaseText::tr("At frame %1, %2 is more than %3 px away.")
            .arg(value["frame"], bodyTitle(value["body"]), value["reach"]);
    if (id == "hard-drifts")
        return HardCaseText::tr(
                   "At frame %1, the centre of mass has moved %2 px, although nothing pushed it.")
            .arg(value["frame"], value["drift"]);
    if (id == "hard-stick")
        return HardCaseText::tr("At frame %1, the length of the stick between %2 and %3 is wrong by %4 px, "
                                "more than the expected %5 px.")
            .arg(value["frame"], bodyTitle(value["a"]), bodyTitle(value["b"]), value["error"], value["most"]);
    if (id == "hard-moves")
        return HardCaseText::tr("At the end, %1 still moves %2 px a frame.")
            .arg(bodyTitle(value["body"]), value["speed"]);
    if (id == "hard-elsewhere")
        return HardCaseText::tr("At the end, %1 is %2 px from where it should rest.")
            .arg(bodyTitle(value["body"]), value["off"]);
    if (id == "hard-length")
        return HardCaseText::tr("At the end, the distance between %1 and %2 is wrong by %3 px.")
            .arg(bodyTitle(value["a"]), bodyTitle(value["b"]), value["off"]);
    if (id == "hard-not-the-same")
        return HardCaseText::tr("A second run differs from the first one at frame %1.").arg(value["frame"]);
    if (id == "hard-not-refused")
        return HardCaseText::tr("This input should be rejected, but it was accepted.");
    if (id == "hard-does-not-end")
        return HardCaseText::tr(
            "The run should stop and name the number that is not finite, but it does not.");
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
