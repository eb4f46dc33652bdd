#include "app/ui/code/listing/listing_editor.h"

#include "app/model/listing/listing_names.h"
#include "app/ui/actions/command.h"
#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/listing/listing_editor_styles.h"
#include "app/ui/code/scintilla_style.h"
#include "app/ui/theme/theme.h"

#include <QGuiApplication>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSignalBlocker>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr int tabColumns = 4;
constexpr int leastChipRoom = 46; ///< px right of the code: a value with some digits

}

ListingEditor::ListingEditor(const Theme &theme, Kind kind, const ParameterDrag &drag, QWidget *parent)
    : QsciScintilla(parent), m_theme(theme), m_kind(kind), m_parameterDrag(drag)
{
    setLayoutDirection(Qt::LeftToRight); // code is not mirrored
    if (kind == Kind::listing) {
        setAccessibleName(tr("Listing: the code that you can change"));
        setAccessibleDescription(
            tr("Type to change it; the run is computed again after a short pause. Tab indents, "
               "%1 completes a name, %2 sets a breakpoint, Esc leaves the editor.")
                .arg(keyText(codeKeys::completeName), keyText(codeKeys::toggleBreakpoint)));
    } else {
        setAccessibleName(tr("My rule: forces that you write"));
        setAccessibleDescription(
            tr("Type to change it; the run is computed again after a short pause. Tab indents, "
               "%1 completes a name, Esc leaves the editor.")
                .arg(keyText(codeKeys::completeName)));
    }
    m_typing.setSingleShot(true);
    m_typing.setInterval(pauseMilliseconds);
    connect(&m_typing, &QTimer::timeout, this, [this] { emit written(text()); });
    setUp();
    applyTheme();
    connect(&theme, &Theme::changed, this, &ListingEditor::applyTheme);
    connect(this, &QsciScintilla::textChanged, this, [this] {
        if (!m_isSetting)
            m_typing.start();
    });
    // Scintilla accepts no other changes while it reports one.
    connect(this, &QsciScintilla::textChanged, this, &ListingEditor::followText, Qt::QueuedConnection);
    connect(this, &QsciScintillaBase::SCN_CHARADDED, this, &ListingEditor::followCharacter,
            Qt::QueuedConnection);
    connect(this, &QsciScintillaBase::SCN_UPDATEUI, this, &ListingEditor::showBrackets);
    // Scintilla does not scroll the values that are painted over the text.
    connect(verticalScrollBar(), &QScrollBar::valueChanged, viewport(), qOverload<>(&QWidget::update));
}

void ListingEditor::setUp()
{
    setUpCode(*this, NumberMargin, 1 << nextMargin);
    setEolMode(EolUnix);
    setAcceptDrops(false); // the window takes files
    viewport()->setAcceptDrops(false);
    setIndentationsUseTabs(false);
    setTabWidth(tabColumns);
    setIndentationWidth(tabColumns);
    send(*this, SCI_SETUNDOCOLLECTION, 0); // undo is the session's
    setWrapMode(WrapWhitespace);           // by words, a row could begin with ");"
    setWrapIndentMode(WrapIndentIndented);
    send(*this, SCI_SETSCROLLWIDTH, 1); // nothing to scroll sideways
    if (m_kind == Kind::listing)
        send(*this, SCI_SETMARGINRIGHT, 0, leastChipRoom);
    send(*this, SCI_AUTOCSETORDER, SC_ORDER_PRESORTED);
    send(*this, SCI_AUTOCSETMAXHEIGHT, 8);
    send(*this, SCI_INDICSETSTYLE, mistakeIndicator, INDIC_SQUIGGLE);
    send(*this, SCI_INDICSETSTYLE, dragIndicator, INDIC_DOTS);
    send(*this, SCI_INDICSETSTYLE, useIndicator, INDIC_BOX);
    markerDefine(Background, nextText);
    markerDefine(FullRectangle, nextMargin);
}

void ListingEditor::applyTheme()
{
    const Tokens &t = m_theme.tokens();
    const double letterPixels = isNarrow(viewport()->width()) ? 12.0 : 13.0;
    styleCode(*this, m_theme, letterPixels);
    for (const int marker : {nextText, nextMargin})
        setMarkerBackgroundColor(t.wash, marker), setMarkerForegroundColor(t.wash, marker);
    QFont bold = inPoints(*this, m_theme.mono(), letterPixels);
    bold.setWeight(QFont::Bold);
    defineStyle(*this, STYLE_BRACELIGHT, bold, t.ink, t.sunk);
    defineStyle(*this, STYLE_BRACEBAD, bold, t.past, t.panel);
    setCaretForegroundColor(t.ink);
    SendScintilla(SCI_INDICSETFORE, mistakeIndicator, t.past);
    SendScintilla(SCI_INDICSETFORE, dragIndicator, t.ink3);
    SendScintilla(SCI_INDICSETFORE, useIndicator, t.ink2);
    viewport()->update();
}

void ListingEditor::setListing(const QString &listing)
{
    m_typing.stop();
    const QByteArray now = text().toUtf8(), then = listing.toUtf8();
    if (now == then)
        return;
    qsizetype head = std::mismatch(now.begin(), now.end(), then.begin(), then.end()).first - now.begin();
    const auto isInsideLetter = [](const QByteArray &bytes, qsizetype at) {
        return at < bytes.size() && (static_cast<unsigned char>(bytes[at]) & 0xC0U) == 0x80U;
    };
    while (head > 0 && (isInsideLetter(now, head) || isInsideLetter(then, head)))
        --head;
    qsizetype tail = 0;
    while (tail < std::min(now.size(), then.size()) - head &&
           now[now.size() - 1 - tail] == then[then.size() - 1 - tail])
        ++tail;
    while (tail > 0 && isInsideLetter(now, now.size() - tail))
        --tail;
    m_isSetting = true;
    const QByteArray middle = then.mid(head, then.size() - tail - head);
    replaceText(*this, head, now.size() - tail, middle);
    m_isSetting = false;
    if (hasFocus())
        send(*this, SCI_GOTOPOS, head + middle.size());
}

void ListingEditor::showTop()
{
    send(*this, SCI_GOTOPOS, 0);
    send(*this, SCI_SETFIRSTVISIBLELINE, 0);
}

void ListingEditor::flush()
{
    if (!isPending())
        return;
    m_typing.stop();
    emit written(text());
}

void ListingEditor::followText()
{
    styleText();
    underlineSpots();
    setPointed(std::nullopt); // another word may be under the mouse now
}

void ListingEditor::styleText()
{
    QByteArray inks;
    for (const QString &line : text().split('\n'))
        inks += inksOf(line) + '\0';
    inks.chop(1);
    send(*this, SCI_STARTSTYLING, 0);
    send(*this, SCI_SETSTYLINGEX, inks.size(), inks);
}

void ListingEditor::underlineSpots()
{
    m_parameterUses = usesOfParameters(text(), m_parameters);
    startIndicator(*this, dragIndicator);
    for (int line = 1; line <= lines(); ++line) {
        for (const Spot &spot : spotsOf(line))
            fillIndicator(*this, positionOf(spot.range), endOf(spot.range));
    }
}

std::vector<ListingEditor::Spot> ListingEditor::spotsOf(int line) const
{
    static const QRegularExpression tokens(QStringLiteral(R"(//.*|(?<![\w.\[])\d+(?:\.\d+)?(?![\w.]))"));
    const QString code = text(line - 1);
    std::vector<Spot> spots;
    for (auto found = tokens.globalMatch(code); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString token = match.captured();
        if (!token[0].isDigit())
            continue; // a comment
        const auto start = static_cast<int>(match.capturedStart());
        spots.push_back({{line, start + 1, static_cast<int>(token.size())}, token, true});
    }
    for (const TextRange &use : m_parameterUses) {
        if (use.line == line)
            spots.push_back({use, code.mid(use.column - 1, use.length), false});
    }
    return spots;
}

/// Marks the bracket beside the caret and its partner. QScintilla's own marks take '<' for a bracket, too.
void ListingEditor::showBrackets()
{
    const auto isBracket = [this](long at) {
        return at >= 0 && QByteArray("()[]{}").contains(static_cast<char>(send(*this, SCI_GETCHARAT, at)));
    };
    constexpr long nowhere = -1;
    const long caret = send(*this, SCI_GETCURRENTPOS);
    const long at = isBracket(caret - 1) ? caret - 1 : isBracket(caret) ? caret : nowhere;
    const long partner = at == nowhere ? nowhere : send(*this, SCI_BRACEMATCH, at);
    if (at != nowhere && partner == nowhere)
        send(*this, SCI_BRACEBADLIGHT, at);
    else
        send(*this, SCI_BRACEHIGHLIGHT, at, partner);
}

void ListingEditor::setMistakes(const std::vector<CodeMistake> &mistakes)
{
    if (mistakes == m_mistakes)
        return;
    m_mistakes = mistakes;
    startIndicator(*this, mistakeIndicator);
    const long length = send(*this, SCI_GETLENGTH);
    for (const CodeMistake &mistake : mistakes) {
        // A mistake at the end of the text has no letter of its own: the last one is underlined.
        const long from = std::clamp(positionOf(mistake.line, mistake.column), 0L, std::max(0L, length - 1));
        const long to =
            std::min(length, std::max(from + 1, positionOf(mistake.line, mistake.column + mistake.length)));
        fillIndicator(*this, from, to);
    }
}

void ListingEditor::setChangedLines(const ChangedLines &changed)
{
    if (changed == m_changed)
        return;
    m_changed = changed;
    viewport()->update();
}

void ListingEditor::setMarks(const LineMarks &marks)
{
    if (marks == m_marks)
        return;
    const bool moved = marks.next != m_marks.next && marks.next > 0 && marks.isInside;
    m_marks = marks;
    markerDeleteAll();
    if (marks.next > 0 && marks.isInside) {
        markerAdd(marks.next - 1, nextText);
        markerAdd(marks.next - 1, nextMargin);
    }
    if (moved) {
        const long start = positionOf(marks.next, 1);
        send(*this, SCI_SCROLLRANGE, start, start);
    }
    viewport()->update();
}

void ListingEditor::setStops(std::vector<LineStop> stops)
{
    if (stops == m_stops)
        return;
    m_stops = std::move(stops);
    viewport()->update();
}

void ListingEditor::showLine(int line)
{
    const long start = positionOf(line, 1);
    send(*this, SCI_GOTOPOS, start);
    send(*this, SCI_SCROLLRANGE, start, start);
}

void ListingEditor::writeBehind(int line)
{
    const QString code = text(line - 1);
    setCursorPosition(line - 1, static_cast<int>(code.size()) - (code.endsWith('\n') ? 1 : 0));
    constexpr int linesAbove = 4; // which say what to write, and have names for it
    send(*this, SCI_SCROLLRANGE, positionOf(std::max(1, line - linesAbove), 1),
         send(*this, SCI_GETCURRENTPOS));
}

void ListingEditor::setValues(LineValues values)
{
    if (values == m_values)
        return;
    m_values = std::move(values);
    viewport()->update();
}

void ListingEditor::readParameters()
{
    const QStringList ids = m_parameterDrag.parameters();
    if (std::exchange(m_parameters, ids) != ids)
        underlineSpots();
}

void ListingEditor::setUses(const std::vector<TextRange> &uses)
{
    startIndicator(*this, useIndicator);
    for (const TextRange &use : uses)
        fillIndicator(*this, positionOf(use), endOf(use));
}

void ListingEditor::showCompletions(const QStringList &names)
{
    int line = 0, index = 0;
    getCursorPosition(&line, &index);
    static const QRegularExpression lastWord(QStringLiteral("\\w*$"));
    const QString word = lastWord.match(textBefore(line + 1, index)).captured();
    // QScintilla 2.13 crashes if it places the list where there is no screen.
    const QRect row = lineRect(line + 1);
    const bool isOnScreen = QGuiApplication::screenAt(viewport()->mapToGlobal(row.topLeft())) &&
                            QGuiApplication::screenAt(viewport()->mapToGlobal(row.bottomRight()));
    if (names.isEmpty() || names == QStringList(word) || !isOnScreen) {
        send(*this, SCI_AUTOCCANCEL);
        return;
    }
    send(*this, SCI_AUTOCSHOW, word.toUtf8().size(), names.join(' ').toUtf8());
}

bool ListingEditor::isUnderlined(int line, int column) const
{
    return send(*this, SCI_INDICATORVALUEAT, mistakeIndicator, positionOf(line, column)) != 0;
}

bool ListingEditor::isUse(int line, int column) const
{
    return send(*this, SCI_INDICATORVALUEAT, useIndicator, positionOf(line, column)) != 0;
}

bool ListingEditor::isListActive() const
{
    return send(*this, SCI_AUTOCACTIVE) != 0;
}

QString ListingEditor::textBefore(int line, int index) const
{
    return text(line - 1).left(index);
}

}
