#include "app/ui/accuracy/accuracy_panel.h"

#include "app/model/text/accuracy_text.h"
#include "app/ui/accuracy/order_plot.h"
#include "app/ui/accuracy/run_plot.h"
#include "app/ui/accuracy/work_precision_plot.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/dock/progress_line.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/plots/plot_export.h"

#include <QAbstractButton>
#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QTextDocumentFragment>
#include <QVBoxLayout>

#include <algorithm>
#include <set>

namespace app {

namespace {

constexpr int margin = 16;
constexpr int leastPlot = 150;   ///< px; below that a plot tells nothing
constexpr int leastRemarks = 36; ///< px: two lines; what does not fit is scrolled to

QLabel *plainLabel(const char *name, QWidget *parent)
{
    QLabel *label = makeTextLabel(name, {}, parent);
    label->setTextFormat(Qt::PlainText);
    label->setContentsMargins(margin, 0, margin, 0);
    return label;
}

}

AccuracyPanel::AccuracyPanel(AccuracyStudy &study, const Preview &preview, const Theme &theme,
                             QWidget *parent)
    : QWidget(parent), m_study(study)
{
    styleAsPanel(*this);
    m_title = new PanelTitle(tr("Accuracy"), theme, this);
    m_views = new QStackedWidget(this);
    m_workPrecision = new WorkPrecisionPlot(study, theme, m_views);
    m_views->addWidget(m_workPrecision);
    m_overTheRun = new RunPlot(study, preview, theme, m_views);
    m_views->addWidget(m_overTheRun);
    connect(m_overTheRun, &RunPlot::pointedAt, this, &AccuracyPanel::pointedAt);
    m_views->addWidget(new OrderPlot(study, theme, m_views));
    const auto seen = [this] { return static_cast<StudyPlot *>(m_views->currentWidget()); };
    m_export = new PlotExport([seen] { return seen()->picture(); }, theme, this);
    m_export->setNumbersAsText([seen] { return seen()->numbers(); });
    for (int i = 0; i < m_views->count(); ++i)
        m_export->addContextMenu(*m_views->widget(i));
    m_showsAll = QSettings().value(showsAllKey, false).toBool();
    m_tabRow = tabs();
    m_title->addAction(m_tabRow);
    m_all = choiceButton("allMethods", tr("Show all methods"),
                         tr("All measured methods, with two more plots and with remarks"), true);
    m_title->addAction(m_all);
    m_title->addAction(m_export->makeButton(this));
    m_unstable = plainLabel("failure", this);
    m_views->setMinimumHeight(leastPlot);
    makeRemarks();
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 12);
    column->setSpacing(8);
    column->addWidget(m_title);
    column->addWidget(m_unstable);
    column->addWidget(m_views, 1);
    column->addWidget(stateRow());
    column->addWidget(card(theme));
    column->addWidget(m_remarksArea);
    connect(&study, &AccuracyStudy::changed, this, &AccuracyPanel::refresh);
    connect(m_workPrecision, &WorkPrecisionPlot::targetChanged, this, &AccuracyPanel::refresh);
    refresh();
}

void AccuracyPanel::makeRemarks()
{
    m_remarks = plainLabel("caption", this);
    m_remarks->setAlignment(Qt::AlignTop);
    m_remarksArea = makeScrollArea(*this);
    m_remarksArea->setFocusPolicy(Qt::StrongFocus); // the arrow keys scroll
    m_remarksArea->setWidget(m_remarks);
    m_remarks->setAutoFillBackground(false);
    m_remarksArea->viewport()->setAutoFillBackground(false);
}

QWidget *AccuracyPanel::tabs()
{
    auto *row = new QWidget(this);
    m_tabs = makeTabs({{tr("Error against time"), tr("The error of each method, and its cost")},
                       {tr("Over the run"), tr("How the error grows, at about the cost of your method")},
                       {tr("Order"), tr("How fast the error shrinks when the step does")}},
                      row);
    connect(m_tabs, &QButtonGroup::idClicked, m_views, &QStackedWidget::setCurrentIndex);
    return row;
}

QWidget *AccuracyPanel::stateRow()
{
    auto *row = new QWidget(this);
    auto *layout = new QHBoxLayout(row);
    layout->setContentsMargins(margin, 0, margin, 0);
    m_state = makeTextLabel("caption", {}, row);
    m_fewer =
        choiceButton("fewerMethods", tr("Show fewer methods"),
                     tr("Only the method of this step, and the two most useful to compare it with"), false);
    m_progress = new ProgressLine(tr("Progress of the measurement"), row);
    m_progress->setMaximumWidth(160);
    m_measure = new QPushButton(row);
    m_measure->setObjectName("measure");
    m_measure->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(m_state, 1);
    layout->addWidget(m_progress);
    layout->addWidget(m_fewer);
    layout->addWidget(m_measure);
    connect(m_measure, &QPushButton::clicked, this, &AccuracyPanel::measureOrCancel);
    m_stateRow = row;
    return row;
}

QWidget *AccuracyPanel::card(const Theme &theme)
{
    auto *outside = new QWidget(this);
    auto *around = new QHBoxLayout(outside);
    around->setContentsMargins(margin, 0, margin, 0);
    auto *card = new QFrame(outside);
    card->setObjectName("sentence");
    around->addWidget(card);
    auto *layout = new QHBoxLayout(card);
    layout->setContentsMargins(14, 10, 12, 10);
    layout->setSpacing(12);
    m_verdict = new QLabel(card);
    m_verdict->setFont(theme.ui(14));
    m_verdict->setTextFormat(Qt::RichText);
    m_verdict->setWordWrap(true);
    m_use = new QPushButton(tr("Use it"), card);
    m_use->setObjectName("use");
    m_use->setFocusPolicy(Qt::TabFocus);
    layout->addWidget(m_verdict, 1);
    layout->addWidget(m_use, 0, Qt::AlignVCenter);
    connect(m_use, &QPushButton::clicked, this, &AccuracyPanel::useCheapest);
    return outside;
}

QPushButton *AccuracyPanel::choiceButton(const char *name, const QString &text, const QString &tip, bool all)
{
    auto *button = new QPushButton(text, this);
    button->setObjectName(name);
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, all] {
        const bool hadFocus = m_all->hasFocus() || m_fewer->hasFocus();
        QSettings().setValue(showsAllKey, all);
        setShowsAll(all);
        if (hadFocus) // the button is gone, the other one is there
            (all ? m_fewer : m_all)->setFocus(Qt::OtherFocusReason);
    });
    return button;
}

void AccuracyPanel::setView(View view)
{
    m_tabs->button(view)->setChecked(true);
    m_views->setCurrentIndex(view);
}

AccuracyPanel::View AccuracyPanel::view() const
{
    return static_cast<View>(m_views->currentIndex());
}

void AccuracyPanel::setShowsAll(bool all)
{
    if (all == m_showsAll)
        return;
    m_showsAll = all;
    if (!all)
        setView(errorAgainstTime);
    refresh();
}

QString AccuracyPanel::verdict() const
{
    return QTextDocumentFragment::fromHtml(m_verdict->text()).toPlainText();
}

QString AccuracyPanel::remarks() const
{
    return m_remarks->text();
}

void AccuracyPanel::fitRemarks()
{
    const int whole = std::max(0, m_remarks->heightForWidth(m_remarksArea->viewport()->width()));
    m_remarksArea->setMinimumHeight(std::min(whole, leastRemarks));
    m_remarksArea->setMaximumHeight(whole);
}

void AccuracyPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    fitRemarks();
}

void AccuracyPanel::refresh()
{
    const sim::Accuracy *accuracy = m_study.accuracy();
    chooseMethods();
    refreshState();
    m_title->layout()->activate(); // the buttons in it are others, perhaps: the caption has what room is left
    m_title->setCaption(accuracy ? captionOf(*accuracy) : QString());
    const QString unstable = accuracy ? unstableWords(*accuracy) : QString();
    m_unstable->setText(unstable.isEmpty() ? QString() : QStringLiteral("✕ ") + unstable);
    m_unstable->setVisible(showsAll() && !unstable.isEmpty());
    const QString remarks = accuracy ? remarksOn(*accuracy).join(QStringLiteral("\n")) : QString();
    m_remarks->setText(remarks);
    m_remarksArea->setVisible(showsAll() && !remarks.isEmpty());
    fitRemarks();
    refreshCard();
}

QString AccuracyPanel::captionOf(const sim::Accuracy &accuracy) const
{
    if (accuracy.previewed > 0)
        return tr("first %1 frames of %2").arg(accuracy.previewed).arg(accuracy.span);
    std::set<std::string> methods, shown;
    for (const sim::AccuracyRow &row : accuracy.rows) {
        methods.insert(row.setup.method->id());
        if (m_workPrecision->shown().has(*row.setup.method))
            shown.insert(row.setup.method->id());
    }
    const auto frames = accuracy.horizon > 0 ? accuracy.horizon : accuracy.span;
    return shown.size() == methods.size()
               ? tr("%1 frames, %2 methods").arg(frames).arg(methods.size())
               : tr("%1 frames, %2 of %3 methods").arg(frames).arg(shown.size()).arg(methods.size());
}

/// Shows the step's own method and the two most telling others. Which those are is known once there are times; until
/// then the plots show the step's own method only.
void AccuracyPanel::chooseMethods()
{
    ShownMethods shown{showsAll()};
    const sim::Accuracy *accuracy = m_study.accuracy();
    if (!shown.areAll && accuracy) {
        const OpenRun &run = m_study.run();
        const std::string own = run.step().script().method->id();
        const bool isEarly = m_study.stage() == AccuracyStudy::Stage::measuring;
        const std::vector<std::string> telling =
            isEarly ? std::vector<std::string>{own}
                    : representativeMethods(*accuracy, own, m_workPrecision->target());
        shown.ids = {telling.begin(), telling.end()};
        shown.ids.insert(run.timeline().script().method->id());
    }
    for (int i = 0; i < m_views->count(); ++i)
        static_cast<StudyPlot *>(m_views->widget(i))->setShown(shown);
}

void AccuracyPanel::refreshState()
{
    using Stage = AccuracyStudy::Stage;
    const bool measuring = m_study.stage() == Stage::measuring;
    m_all->setVisible(!m_showsAll);
    m_fewer->setVisible(m_showsAll);
    m_tabRow->setVisible(m_showsAll);
    m_stateRow->setVisible(m_showsAll ||
                           m_study.stage() != Stage::done); // a plot that is done speaks for itself
    m_progress->setVisible(measuring);
    m_progress->setShare(m_study.done());
    m_measure->setText(measuring ? tr("Cancel") : m_study.accuracy() ? tr("Measure again") : tr("Measure"));
    m_measure->setToolTip(measuring ? tr("Cancel; the results so far stay")
                                    : tr("Compute the scene with every method, and time it"));
    switch (m_study.stage()) {
    case Stage::measuring:
        m_state->setText(tr("Measuring…"));
        break;
    case Stage::done:
        m_state->setText(tr("Times are medians of repeated, interleaved runs; whiskers show their spread."));
        break;
    case Stage::cancelled:
        m_state->setText(tr("Cancelled. The results so far are shown."));
        break;
    case Stage::refused:
        m_state->setText(m_study.error());
        break;
    case Stage::none:
        m_state->setText(m_study.isDue()
                             ? tr("The scene has changed. Measuring starts when you stop changing it.")
                             : tr("Not measured yet."));
        break;
    }
}

const sim::AccuracyRow *AccuracyPanel::cheapest() const
{
    return m_study.accuracy() ? m_study.accuracy()->cheapest(m_workPrecision->target()) : nullptr;
}

void AccuracyPanel::refreshCard()
{
    const sim::Accuracy *accuracy = m_study.accuracy();
    QString text =
        accuracy ? verdictOn(*accuracy, m_workPrecision->target(), m_study.inUse())
                 : tr("How accurate is each method for this scene, and what does it cost? Every method "
                      "computes it with many steps, and is compared with a far more accurate reference.");
    if (accuracy && !m_study.leftOut().isEmpty())
        text += ' ' + m_study.leftOut();
    if (text != m_verdict->text())
        m_verdict->setText(text);
    const sim::AccuracyRow *best = cheapest();
    m_use->setVisible(best && best != m_study.inUse());
    if (best)
        m_use->setToolTip(tr("Use %1").arg(setupTitle(best->setup)));
}

void AccuracyPanel::measureOrCancel()
{
    if (m_study.stage() == AccuracyStudy::Stage::measuring)
        m_study.cancel();
    else
        m_study.start();
}

void AccuracyPanel::useCheapest()
{
    if (const sim::AccuracyRow *best = cheapest())
        m_study.adopt(best->setup);
}

void AccuracyPanel::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_study.setActive(true);
}

void AccuracyPanel::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    m_study.setActive(false);
}

}
