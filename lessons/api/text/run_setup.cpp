#include "lessons/api/text/run_setup.h"

#include "lessons/api/text/document.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <optional>

namespace lessons {

std::vector<double> numbersIn(const QString &text)
{
    std::vector<double> numbers;
    for (const QString &part : text.split(',')) {
        bool isNumber = false;
        numbers.push_back(part.trimmed().toDouble(&isNumber));
        if (!isNumber || !std::isfinite(numbers.back()))
            return {};
    }
    return numbers;
}

namespace {

struct RunSetupReaderText
{
    Q_DECLARE_TR_FUNCTIONS(RunSetupReaderText)
};

/// Reads the items of a run.
class RunSetupReader
{
public:
    explicit RunSetupReader(const QString &file) : m_file(file) {}

    void read(const ListItem &item)
    {
        static const QString drag = QStringLiteral("drag ");
        if (item.name == u"frames")
            setFrames(item);
        else if (item.name == u"until")
            setOnce(m_run.until, item);
        else if (item.name == u"method")
            setOnce(m_run.method, item);
        else if (item.name == u"step")
            setOnce(m_run.step, item);
        else if (item.name.startsWith(drag))
            m_run.drags.push_back(dragIn(item, item.name.mid(drag.size())));
        else if (item.name == u"press")
            m_run.press = pressIn(item);
        else if (item.name == u"click")
            m_run.click = placeIn(item);
        else if (item.name == u"drag")
            reject(item, RunSetupReaderText::tr(
                             "nothing says which body to drag. Write its name, as in “- drag foot: %1”.")
                             .arg(item.value));
        else if (item.value.contains(','))
            m_run.places.push_back({item.name, placeIn(item)});
        else
            m_run.values.emplace_back(item.name, item.value);
    }

    RunSetup run() const { return m_run; }

private:
    [[noreturn]] void reject(const ListItem &item, const QString &why) const
    {
        throw DocumentError(m_file, item.line, why);
    }

    void checkOnce(bool isThere, const ListItem &item) const
    {
        if (isThere)
            reject(item, RunSetupReaderText::tr("“%1” is there twice. Remove one of them.").arg(item.name));
    }

    void setFrames(const ListItem &item)
    {
        checkOnce(m_run.frames > 0, item);
        m_run.frames = framesIn(item, item.value);
    }

    void setOnce(QString &text, const ListItem &item) const
    {
        checkOnce(!text.isEmpty(), item);
        text = item.value;
    }

    int framesIn(const ListItem &item, const QString &text) const
    {
        bool isNumber = false;
        const int frames = text.trimmed().toInt(&isNumber);
        if (!isNumber || frames < 1 || frames > RunSetup::mostFrames)
            reject(item, RunSetupReaderText::tr(
                             "“%1” is not a number of frames. Write a whole number from 1 to %2.")
                             .arg(text.trimmed())
                             .arg(RunSetup::mostFrames));
        return frames;
    }

    sim::Vec2 placeIn(const ListItem &item) const
    {
        const std::vector<double> numbers = numbersIn(item.value);
        if (numbers.size() != 2)
            reject(item,
                   RunSetupReaderText::tr("“%1” is not a place. Write x and y in px, as in “- %2: 300, 220”.")
                       .arg(item.value, item.name));
        return {numbers[0], numbers[1]};
    }

    RunSetup::Drag dragIn(const ListItem &item, const QString &body) const
    {
        const std::vector<double> numbers = numbersIn(item.value);
        if (numbers.size() != 3)
            reject(item, RunSetupReaderText::tr(
                             "“%1” is incomplete. Write x and y in px and the number of frames, as in "
                             "“- %2: 300, 220, 10”.")
                             .arg(item.value, item.name));
        return {body.trimmed(), {numbers[0], numbers[1]}, framesIn(item, item.value.section(',', 2))};
    }

    RunSetup::Press pressIn(const ListItem &item) const
    {
        const RunSetup::Drag drag = dragIn(item, {});
        return {drag.to, drag.frames};
    }

    QString m_file;
    RunSetup m_run;
};

template <class Items, class Name>
void replaceOrAdd(Items &items, const typename Items::value_type &item, Name name)
{
    const auto same =
        std::find_if(items.begin(), items.end(), [&](const auto &one) { return one.*name == item.*name; });
    if (same == items.end())
        items.push_back(item);
    else
        *same = item;
}

}

std::vector<ListItem> parseList(const DocumentPart &part, const QString &file)
{
    static const QRegularExpression pattern(QStringLiteral("^- ([^:]*[^:\\s])\\s*:\\s*(\\S.*)$"));
    std::vector<ListItem> items;
    int line = part.line;
    for (const QString &text : part.body) {
        ++line;
        if (text.trimmed().isEmpty())
            continue;
        const auto match = pattern.match(text.trimmed());
        if (!match.hasMatch())
            throw DocumentError(file, line,
                                RunSetupReaderText::tr(
                                    "“%1” does not belong in this list. Write “- name: value”, on one line.")
                                    .arg(text.trimmed()));
        items.push_back({match.captured(1), match.captured(2), line});
    }
    if (items.empty())
        throw DocumentError(
            file, part.line,
            RunSetupReaderText::tr(
                "there is no list below “### %1”. Write “- name: value” there, or remove the heading.")
                .arg(part.heading));
    return items;
}

RunSetup parseRunSetup(const DocumentPart &part, const QString &file)
{
    RunSetupReader reader(file);
    for (const ListItem &item : parseList(part, file))
        reader.read(item);
    RunSetup run = reader.run();
    run.line = part.line;
    return run;
}

RunSetup withChanges(RunSetup run, const RunSetup &changes)
{
    for (const auto &value : changes.values)
        replaceOrAdd(run.values, value, &std::pair<QString, QString>::first);
    for (const RunSetup::Place &place : changes.places)
        replaceOrAdd(run.places, place, &RunSetup::Place::body);
    if (!changes.drags.empty())
        run.drags = changes.drags;
    if (changes.press)
        run.press = changes.press;
    if (changes.click)
        run.click = changes.click;
    if (!changes.step.isEmpty())
        run.step = changes.step;
    if (!changes.method.isEmpty())
        run.method = changes.method;
    if (changes.frames > 0)
        run.frames = changes.frames;
    if (!changes.until.isEmpty())
        run.until = changes.until;
    return run;
}

}
