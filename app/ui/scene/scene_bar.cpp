#include "app/ui/scene/scene_bar.h"

#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"
#include "app/ui/actions/command.h"
#include "app/ui/actions/command_button.h"
#include "app/ui/scene/flat_button.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/scene/step_menu.h"
#include "sim/methods/methods.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>

#include <array>

namespace app {

namespace {

constexpr int barHeight = 36;
constexpr int sideMargin = 8;

}

SceneBar::SceneBar(const OpenRun &run, RunEditor &editor, LearnerCode &code, const Theme &theme,
                   QWidget *parent)
    : QWidget(parent), m_run(run), m_editor(editor), m_code(code), m_theme(theme)
{
    setFixedHeight(barHeight);
    m_method = button(tr("How the run is computed from one step to the next"));
    m_step = button({});
    m_show = button(tr("Choose what the picture shows besides the creature"));
    m_zoom = button(tr("Zoom to 100\u2009%"));
    m_fit = button({});
    m_show->setIconName("show");
    m_show->setTexts({}, tr("Show"));
    m_fit->setFixedSize(28, 28);
    auto *row = new QHBoxLayout(this);
    row->setContentsMargins(sideMargin, 0, sideMargin, 0);
    row->setSpacing(0);
    row->setSizeConstraint(QLayout::SetNoConstraint); // captions can be hidden: see minimumSizeHint()
    row->addWidget(m_method);
    row->addWidget(m_step);
    row->addStretch(1);
    row->addWidget(m_show);
    row->addWidget(m_zoom);
    row->addWidget(m_fit);
    fillMethods();
    m_steps = new StepMenu(run, editor, m_step);
    connect(m_steps, &QMenu::aboutToShow, this, &SceneBar::showValues);
    connect(m_steps, &StepMenu::chosen, this, &SceneBar::showValues);
    m_step->setMenu(m_steps);
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::code, this, &SceneBar::showValues);
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
    for (const sim::MethodPtr &method : sim::allMethods()) {
        QAction *action = menu->addAction(phrase(method->title()));
        action->setCheckable(true);
        action->setData(QString::fromStdString(method->id()));
        group->addAction(action);
    }
    menu->setToolTipsVisible(true);
    menu->addSeparator();
    m_listing = menu->addAction(tr("Your code"));
    m_listing->setCheckable(true);
    m_listing->setData(QStringLiteral("listing"));
    group->addAction(m_listing);
    connect(group, &QActionGroup::triggered, this, [this](QAction *action) {
        if (action == m_listing)
            m_code.use();
        else
            m_editor.setMethod(action->data().toString());
        showValues(); // if the method was rejected, this moves the mark back
    });
    connect(menu, &QMenu::aboutToShow, this, &SceneBar::showValues);
    m_method->setMenu(menu);
}

void SceneBar::attach(SceneView &view, Command &fit)
{
    m_view = &view;
    m_fit->setIconName(fit.iconName());
    showCommand(*m_fit, fit, m_theme);
    fillShow();
    connect(&view, &SceneView::zoomChanged, this, &SceneBar::showZoom);
    connect(m_zoom, &QToolButton::clicked, &view, &SceneView::zoomTo100);
    showZoom(view.zoom());
}

void SceneBar::addTool(Command &command)
{
    FlatButton *tool = button({});
    tool->setIconName(command.iconName());
    tool->setFixedSize(28, 28);
    showCommand(*tool, command, m_theme);
    auto *row = static_cast<QHBoxLayout *>(layout());
    row->insertWidget(row->indexOf(m_show), tool);
    m_toolsWidth += tool->width();
    arrange();
}

void SceneBar::setMiddle(QWidget *middle)
{
    if (m_middle) {
        m_middle->hide();
        m_middle->deleteLater(); // not at once: a key event of this widget may have ended it
    }
    m_middle = middle;
    if (middle) {
        auto *row = static_cast<QHBoxLayout *>(layout());
        row->insertWidget(row->indexOf(m_step) + 1, middle, 1000); // before the stretch, which shrinks first
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
                           Item{"guides", tr("Guide lines"), &Extras::overlays},
                           Item{"eyes", tr("Eyes"), &Extras::eyes},
                           Item{"ghost", tr("Ghost"), &Extras::comparison},
                           Item{"onion", tr("Onion skins"), &Extras::onion},
                           Item{"reference", tr("Reference"), &Extras::reference},
                           Item{"pulls", tr("All pulls"), &Extras::pulls},
                           Item{"rests", tr("Rest lengths"), &Extras::rests},
                           Item{"ruler", tr("Ruler"), &Extras::ruler},
                           Item{"clock", tr("Clock"), &Extras::clock},
                           Item{"unitCircle", tr("Unit circle"), &Extras::unitCircle}};
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

void SceneBar::follow(const QString &id, Command &command)
{
    for (QAction *entry : m_show->menu()->actions()) {
        if (entry->data().toString() != id)
            continue;
        // A command that cannot be used has no tick: the scene shows nothing of it.
        const auto tick = [entry, &command] {
            command.setChecked(entry->isChecked() && command.isEnabled());
        };
        tick();
        connect(&command, &QAction::triggered, entry, [entry](bool on) {
            if (entry->isChecked() != on)
                entry->trigger();
        });
        connect(entry, &QAction::toggled, &command, tick);
        connect(&command, &QAction::enabledChanged, &command, tick);
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
    const sim::Script &script = m_run.timeline().script();
    m_method->setTexts(tr("Method"), phrase(script.method->title()));
    const bool adaptive = script.step.isAdaptive();
    m_step->setToolTip(adaptive ? tr("The largest error that the method allows in each of its steps")
                                : tr("How much time one step of the method covers"));
    m_step->setTexts(adaptive ? tr("Tolerance") : tr("Step"), stepTitle(script.step));
    for (QAction *action : m_method->menu()->actions())
        action->setChecked(action->data().toString().toStdString() == script.method->id());
    m_listing->setEnabled(m_code.isOffered());
    m_listing->setToolTip(m_code.isOffered() ? tr("The listing, as you changed it")
                                             : tr("This step has no listing."));
    m_steps->follow();
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
    const int room = width() - middle;
    // In a narrow bar the word "Method" goes first: hints name the control "Step", and "1 frame" alone does not say what it is.
    m_method->setShort(widthWith(m_method->fullWidth(), m_step->fullWidth()) > room);
    m_step->setShort(widthWith(m_method->sizeHint().width(), m_step->fullWidth()) > room);
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
