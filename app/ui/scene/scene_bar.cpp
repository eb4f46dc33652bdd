#include "app/ui/scene/scene_bar.h"

#include "app/model/sentences.h"
#include "app/model/step_words.h"
#include "app/ui/scene/flat_button.h"
#include "app/ui/scene/scene_view.h"
#include "sim/error.h"
#include "sim/methods/methods.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPainter>
#include <QWidgetAction>

#include <array>
#include <cmath>

namespace app {

namespace {

constexpr int barHeight = 36;
constexpr int sideMargin = 8;

const std::array offeredSteps{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 2.0};
const std::array offeredTolerances{1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

constexpr const char *tolerance = "tolerance"; ///< property of menu entries: whether they are tolerances

/// Keeps Return to itself: in a menu it would trigger an entry besides the field that it was typed in.
class FieldRow : public QWidget
{
protected:
    void keyPressEvent(QKeyEvent *event) override
    {
        const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        event->setAccepted(isReturn);
    }
};

/// An action of `menu` that one of its group is on.
QAction *choice(QMenu &menu, QActionGroup &group, const QString &text, const QVariant &data)
{
    QAction *action = menu.addAction(text);
    action->setCheckable(true);
    action->setData(data);
    group.addAction(action);
    return action;
}

}

SceneBar::SceneBar(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme)
{
    setFixedHeight(barHeight);
    m_method = button(tr("How the run is computed from one step to the next"));
    m_step = button(tr("How much time one step of the method covers"));
    m_show = button(tr("What the picture shows besides the creature"));
    m_zoom = button(tr("Zoom to 100\u2009%"));
    m_fit = button(tr("Show the whole stage (Ctrl+0)"));
    m_show->setIconName("show");
    m_show->setTexts({}, tr("Show"));
    m_fit->setIconName("fit");
    m_fit->setFixedSize(28, 28);
    m_fit->setAccessibleName(tr("Fit"));
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(sideMargin, 0, sideMargin, 0);
    row->setSpacing(0);
    row->setSizeConstraint(QLayout::SetNoConstraint); // captions give way: see minimumSizeHint()
    row->addWidget(m_method);
    row->addWidget(m_step);
    row->addStretch(1);
    row->addWidget(m_show);
    row->addWidget(m_zoom);
    row->addWidget(m_fit);
    fillMethods();
    fillSteps();
    connect(&session, &Session::stepOpened, this, &SceneBar::showValues);
    connect(&session, &Session::runChanged, this, &SceneBar::showValues);
    connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    showValues();
}

FlatButton *SceneBar::button(const QString &tip)
{
    auto *made = new FlatButton(m_theme, this);
    made->setToolTip(tip);
    return made;
}

void SceneBar::fillMethods()
{
    auto *menu = new QMenu(m_method);
    auto *group = new QActionGroup(menu);
    for (const sim::MethodPtr &method : sim::allMethods())
        choice(*menu, *group, phrase(method->title()), QString::fromStdString(method->id()));
    connect(group, &QActionGroup::triggered, this, [this](QAction *action) {
        m_session.setMethod(action->data().toString());
        showValues(); // a method that does not fit was refused: the mark goes back
    });
    connect(menu, &QMenu::aboutToShow, this, &SceneBar::showValues);
    m_method->setMenu(menu);
}

void SceneBar::fillSteps()
{
    m_steps = new QMenu(m_step);
    auto *group = new QActionGroup(m_steps);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    for (const double h : offeredSteps)
        choice(*m_steps, *group, stepTitle(h), h)->setProperty(tolerance, false);
    for (const double px : offeredTolerances)
        choice(*m_steps, *group, toleranceTitle(px), px)->setProperty(tolerance, true);
    connect(group, &QActionGroup::triggered, this, [this](QAction *action) {
        const double chosen = action->data().toDouble();
        isAdaptive() ? m_session.setTolerance(chosen) : m_session.setStepSize(chosen);
        showValues();
    });
    m_steps->addSeparator();
    addOtherStep();
    connect(m_steps, &QMenu::aboutToShow, this, [this] {
        m_why->hide();
        showValues();
    });
    m_step->setMenu(m_steps);
}

void SceneBar::addOtherStep()
{
    auto *content = new FieldRow;
    auto *label = new QLabel(tr("Other:"), content);
    m_other = new QLineEdit(content);
    m_other->setFixedWidth(72);
    m_unit = new QLabel(content);
    label->setBuddy(m_other);
    content->setFocusPolicy(Qt::StrongFocus); // the menu gives it the focus when its keys come there
    content->setFocusProxy(m_other);
    m_why = new QLabel(content);
    m_why->setObjectName("caption");
    m_why->setWordWrap(true);
    m_why->setFixedWidth(180);
    m_why->hide();
    auto *grid = new QGridLayout(content);
    grid->setContentsMargins(10, 4, 10, 4);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_other, 0, 1);
    grid->addWidget(m_unit, 0, 2);
    grid->addWidget(m_why, 1, 0, 1, 3);
    auto *action = new QWidgetAction(m_steps);
    action->setDefaultWidget(content);
    m_steps->addAction(action);
    connect(m_other, &QLineEdit::returnPressed, this, &SceneBar::takeOtherStep);
}

bool SceneBar::isAdaptive() const
{
    return m_session.timeline().script().step.adaptive();
}

void SceneBar::offerSteps()
{
    const bool adaptive = isAdaptive();
    for (QAction *action : m_steps->actions()) {
        if (action->isCheckable())
            action->setVisible(action->property(tolerance).toBool() == adaptive);
    }
    m_unit->setText(adaptive ? tr("px") : tr("frames"));
    m_other->setPlaceholderText(adaptive ? QStringLiteral("5e-3") : QStringLiteral("1/6"));
    m_other->setToolTip(
        adaptive ? tr("From 1e-13 to 100 px; Enter takes it")
                 : tr("1 divided by a whole number, or a whole number, in frames; Enter takes it"));
    m_other->setAccessibleName(adaptive ? tr("Other tolerance, in px") : tr("Other step, in frames"));
    m_step->setToolTip(adaptive ? tr("The error that each of the method's own steps may make")
                                : tr("How much time one step of the method covers"));
}

void SceneBar::takeOtherStep()
{
    const double typed = stepFromText(m_other->text());
    const bool adaptive = isAdaptive();
    try {
        adaptive ? sim::StepSize::within(typed) : sim::StepSize::of(typed);
    } catch (const sim::Error &error) {
        m_why->setText(sentenceFor(error));
        m_why->show();
        m_steps->adjustSize();
        return;
    }
    m_steps->close();
    adaptive ? m_session.setTolerance(typed) : m_session.setStepSize(typed);
}

void SceneBar::attach(SceneView &view)
{
    m_view = &view;
    fillShow();
    connect(&view, &SceneView::zoomChanged, this, &SceneBar::showZoom);
    connect(m_zoom, &QToolButton::clicked, &view, &SceneView::zoomTo100);
    connect(m_fit, &QToolButton::clicked, &view, &SceneView::fit);
    showZoom(view.zoom());
}

void SceneBar::addTool(QAction &action, const QString &icon)
{
    FlatButton *tool = button({});
    tool->setIconName(icon);
    tool->setFixedSize(28, 28);
    const auto follow = [tool, &action] {
        tool->setEnabled(action.isEnabled());
        tool->setToolTip(action.toolTip());
        tool->setAccessibleName(action.text().remove('&'));
    };
    follow();
    connect(&action, &QAction::changed, tool, follow);
    connect(tool, &QToolButton::clicked, &action, &QAction::trigger);
    auto *row = static_cast<QHBoxLayout *>(layout());
    row->insertWidget(row->indexOf(m_show), tool);
    m_toolsWidth += tool->width();
    arrange();
}

void SceneBar::setMiddle(QWidget *middle)
{
    if (m_middle) {
        m_middle->hide();
        m_middle->deleteLater(); // a key that was pressed in it may be what ends it
    }
    m_middle = middle;
    if (middle) {
        auto *row = static_cast<QHBoxLayout *>(layout());
        row->insertWidget(row->indexOf(m_step) + 1, middle, 1000); // before the stretch, and at its cost
        middle->show();
    }
    arrange();
}

void SceneBar::fillShow()
{
    struct Item
    {
        const char *id;
        QString text;
        bool Extras::*member;
    };
    const std::array items{Item{"trails", tr("Trails"), &Extras::trails},
                           Item{"velocities", tr("Velocity arrows"), &Extras::velocities},
                           Item{"grid", tr("Grid"), &Extras::grid},
                           Item{"guides", tr("Explaining lines"), &Extras::guides},
                           Item{"eyes", tr("Eyes"), &Extras::eyes},
                           Item{"ghost", tr("Ghost"), &Extras::ghost},
                           Item{"onion", tr("Onion skins"), &Extras::onion},
                           Item{"reference", tr("Reference"), &Extras::reference},
                           Item{"pulls", tr("Pulls of all forces"), &Extras::pulls},
                           Item{"rests", tr("Rest lengths"), &Extras::rests},
                           Item{"ruler", tr("Ruler"), &Extras::ruler},
                           Item{"clock", tr("Clock"), &Extras::clock}};
    auto *menu = new QMenu(m_show);
    for (const Item &item : items) {
        QAction *action = menu->addAction(item.text);
        action->setCheckable(true);
        action->setChecked(m_view->extras().*item.member);
        action->setData(QString(item.id));
        connect(action, &QAction::triggered, this,
                [this, id = QString(item.id)](bool on) { emit chosen(id, on); });
        connect(action, &QAction::toggled, this, [this, member = item.member](bool on) {
            Extras extras = m_view->extras();
            extras.*member = on;
            m_view->setExtras(extras);
        });
        connect(m_view, &SceneView::extrasChanged, action,
                [this, action, member = item.member] { action->setChecked(m_view->extras().*member); });
    }
    m_show->setMenu(menu);
    arrange();
}

void SceneBar::choose(const QString &id, bool on)
{
    for (QAction *action : m_show->menu()->actions()) {
        if (action->data().toString() == id)
            action->setChecked(on);
    }
}

QStringList SceneBar::choices() const
{
    QStringList ids;
    for (const QAction *action : m_show->menu()->actions())
        ids << action->data().toString();
    return ids;
}

void SceneBar::showValues()
{
    const sim::Script &script = m_session.timeline().script();
    m_method->setTexts(tr("Method"), phrase(script.method->title()));
    const bool adaptive = script.step.adaptive();
    const double value = adaptive ? script.step.tolerance : script.step.h;
    m_step->setTexts(adaptive ? tr("Tolerance") : tr("Step"), stepTitle(script.step));
    for (QAction *action : m_method->menu()->actions())
        action->setChecked(action->data().toString().toStdString() == script.method->id());
    offerSteps();
    for (QAction *action : m_steps->actions()) {
        if (action->isCheckable())
            action->setChecked(action->property(tolerance).toBool() == adaptive &&
                               std::abs(action->data().toDouble() / value - 1.0) < 1e-9);
    }
    arrange();
}

void SceneBar::showZoom(double percent)
{
    const QString text = tr("%1\u2009%").arg(qRound(percent));
    m_zoom->setTexts(text, {});
    m_zoom->setAccessibleName(tr("Zoom %1").arg(text));
    arrange();
}

void SceneBar::arrange()
{
    const int middle = m_middle ? m_middle->sizeHint().width() : 0;
    const bool isShort = widthWith(m_method->fullWidth(), m_step->fullWidth()) + middle > width();
    m_method->setShort(isShort);
    m_step->setShort(isShort);
}

int SceneBar::widthWith(int method, int step) const
{
    return 2 * sideMargin + method + step + m_toolsWidth + m_show->fullWidth() + m_zoom->fullWidth() +
           m_fit->width();
}

QSize SceneBar::minimumSizeHint() const
{
    return {widthWith(m_method->shortWidth(), m_step->shortWidth()), barHeight};
}

void SceneBar::paintEvent(QPaintEvent *)
{
    QPainter(this).fillRect(rect(), m_theme.tokens().panel);
}

void SceneBar::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

}
