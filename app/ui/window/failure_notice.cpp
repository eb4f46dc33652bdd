#include "app/ui/window/failure_notice.h"

#include "app/model/run/rule_error.h"
#include "app/model/run/run_program.h"
#include "app/model/text/sentences.h"
#include "app/model/text/stability_text.h"
#include "app/ui/dock/button_flow.h"

#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QUndoStack>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int gap = 12;         ///< px, to the picture's edges
constexpr int mostWidth = 720;  ///< px
constexpr double radius = 10.0; ///< px

QString keyOf(const QString &label)
{
    return QKeySequence::mnemonic(label).toString(QKeySequence::NativeText);
}

}

FailureNotice::FailureNotice(const OpenRun &run, RunEditor &editor, const Theme &theme, QWidget *picture)
    : QFrame(picture), m_run(run), m_editor(editor), m_theme(theme), m_search(run, editor),
      m_text(new QLabel(this)), m_hint(new QLabel(this)), m_buttons(new QWidget(this))
{
    setObjectName("stopNotice");
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_hint->setObjectName("caption");
    m_hint->setWordWrap(true);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(20, 12, 16, 12);
    column->setSpacing(8);
    column->addWidget(m_text);
    column->addWidget(m_hint);
    column->addWidget(m_buttons);
    connect(&m_search, &RemedySearch::changed, this, &FailureNotice::refresh);
    connect(&editor.undoStack(), &QUndoStack::canUndoChanged, this, &FailureNotice::refresh);
    picture->installEventFilter(this);
    refresh();
}

QString FailureNotice::sentence() const
{
    return m_text->text();
}

void FailureNotice::refresh()
{
    const sim::Stop *stop = m_search.stop();
    setVisible(stop);
    if (!stop)
        return;
    m_text->setText(m_run.timeline().stop() ? endSentence(m_run.timeline().track()) : sentenceFor(*stop));
    setAccessibleName(m_text->text());
    const bool isEmpty = m_search.found().empty();
    m_hint->setVisible(isEmpty);
    m_hint->setText(
        runErrorOf(m_run.timeline().track()) || ruleErrorOf(m_run.timeline().track())
            ? m_editor.undoStack().canUndo()
                  ? tr("Correct this line, and the run goes on. Undo reverts your last change.")
                  : tr("Correct this line, and the run goes on.")
        : m_search.isSearching()
            ? tr("Searching for a remedy…")
            : tr("No smaller step and no other method was found to be stable. Go back, and undo the change "
                 "that caused this."));
    showRemedies();
    place();
}

void FailureNotice::showRemedies()
{
    delete m_buttons;
    m_buttons = new QWidget(this);
    layout()->addWidget(m_buttons);
    auto *column = new QVBoxLayout(m_buttons);
    column->setContentsMargins(0, 0, 0, 0);
    auto *flow = new ButtonFlow(m_buttons);
    column->addWidget(flow);
    for (const sim::Remedy &remedy : m_search.found()) {
        const QString label = remedyLabel(remedy);
        auto *button = flow->add<QPushButton>(
            "remedy", label, QStringLiteral("%1 (%2)").arg(remedyHelp(remedy), keyOf(label)));
        button->setAccessibleName(remedyTitle(remedy));
        button->setAccessibleDescription(remedyHelp(remedy));
        // Queued: using a remedy takes this button away.
        connect(
            button, &QPushButton::clicked, this, [this, remedy] { use(remedy); }, Qt::QueuedConnection);
    }
    m_buttons->setVisible(
        !m_search.found().empty()); // last, because no child may be added to a visible parent
}

void FailureNotice::use(const sim::Remedy &remedy)
{
    parentWidget()->setFocus(); // so that keys act on the run
    m_editor.use(remedy);
}

void FailureNotice::place()
{
    const QWidget *picture = parentWidget();
    const int width = std::min(mostWidth, picture->width() - 2 * gap);
    setGeometry(gap, gap, width, heightForWidth(width));
    raise();
}

bool FailureNotice::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible())
        place();
    return QFrame::eventFilter(watched, event);
}

void FailureNotice::paintEvent(QPaintEvent *)
{
    const Tokens &tokens = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(tokens.line2);
    painter.setBrush(tokens.panel);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens.past);
    painter.drawRoundedRect(QRectF(8.0, 12.0, 3.0, height() - 24.0), 1.5, 1.5);
}

}
