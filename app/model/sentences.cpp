#include "app/model/sentences.h"

#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Sentences)
};

QString value(const sim::Error &error, const char *name)
{
    const auto found = error.values().find(name);
    return found == error.values().end() ? QString() : QString::fromStdString(found->second);
}

}

QString phrase(const std::string &text)
{
    return QCoreApplication::translate("sim", text.c_str());
}

QString sentenceFor(const sim::Error &error)
{
    if (error.id() == "step-size")
        return Text::tr(
                   "The step %1 does not fit: it can be 1 divided by a whole number, or a whole number, from "
                   "0.000001 to 100 frames.")
            .arg(value(error, "h"));
    if (error.id() == "method-does-not-fit")
        return Text::tr("The method %1 cannot compute %2: choose another method, or switch that effect off.")
            .arg(value(error, "method"), value(error, "effect"));
    if (error.id() == "nothing-moves")
        return Text::tr("Nothing in this scene can move: leave at least one body free.");
    return Text::tr("This does not fit together: %1.").arg(QString::fromUtf8(error.what()));
}

QString sentenceFor(const sim::Stop &stop)
{
    const QString name = QString::fromStdString(stop.body);
    if (stop.phase.empty())
        return Text::tr("Stopped at frame %1: the next one is not finite. It began at %2.")
            .arg(stop.frame)
            .arg(name);
    return Text::tr("Stopped at frame %1: the next one is not finite. It began at %2, in %3.")
        .arg(stop.frame)
        .arg(name, phrase(stop.phase));
}

}
