#include "app/ui/scene/step_menu.h"

#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"
#include "sim/base/error.h"

#include <QActionGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QWidgetAction>

#include <array>
#include <cmath>

namespace app {

namespace {

const std::array offeredSteps{1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0, 2.0};
const std::array offeredTolerances{1.0, 1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8};

constexpr const char *tolerance = "tolerance"; ///< property of entries: whether they are tolerances

/// Accepts Return, which would otherwise also trigger an entry of the menu.
class FieldRow : public QWidget
{
protected:
    void keyPressEvent(QKeyEvent *event) override
    {
        const bool isReturn = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        event->setAccepted(isReturn);
    }
};

}

StepMenu::StepMenu(const OpenRun &run, RunEditor &editor, QWidget *parent)
    : QMenu(parent), m_run(run), m_editor(editor)
{
    auto *group = new QActionGroup(this);
    group->setExclusionPolicy(QActionGroup::ExclusionPolicy::ExclusiveOptional);
    const auto offer = [&](const QString &text, double value, bool isTolerance) {
        QAction *action = addAction(text);
        action->setCheckable(true);
        action->setData(value);
        action->setProperty(tolerance, isTolerance);
        group->addAction(action);
    };
    for (const double h : offeredSteps)
        offer(stepTitle(h), h, false);
    for (const double px : offeredTolerances)
        offer(toleranceTitle(px), px, true);
    connect(group, &QActionGroup::triggered, this, [this](QAction *action) {
        const double value = action->data().toDouble();
        isAdaptive() ? m_editor.setTolerance(value) : m_editor.setStepSize(value);
        emit chosen();
    });
    addSeparator();
    addOther();
    connect(this, &QMenu::aboutToShow, this, [this] {
        m_other->clear(); // a value typed earlier belonged to another run
        m_whyEntry->setVisible(false);
        m_why->hide(); // the menu does not hide the widget of an entry that it leaves out
    });
}

void StepMenu::addOther()
{
    auto *content = new FieldRow;
    auto *label = new QLabel(tr("Other:"), content);
    m_other = new QLineEdit(content);
    m_other->setFixedWidth(72);
    m_unit = new QLabel(content);
    label->setBuddy(m_other);
    content->setFocusPolicy(Qt::StrongFocus); // the menu focuses this widget when keys select its action
    content->setFocusProxy(m_other);
    auto *row = new QHBoxLayout(content);
    row->setContentsMargins(10, 4, 10, 4);
    row->addWidget(label);
    row->addWidget(m_other);
    row->addWidget(m_unit);
    auto *action = new QWidgetAction(this);
    action->setDefaultWidget(content);
    addAction(action);
    // An entry of its own: a menu does not notice that a widget in it has grown.
    m_why = new QLabel(this);
    m_why->setObjectName("caption");
    m_why->setWordWrap(true);
    m_why->setContentsMargins(10, 0, 10, 4);
    m_whyEntry = new QWidgetAction(this);
    m_whyEntry->setDefaultWidget(m_why);
    m_whyEntry->setVisible(false);
    addAction(m_whyEntry);
    connect(m_other, &QLineEdit::returnPressed, this, &StepMenu::takeOther);
}

bool StepMenu::isAdaptive() const
{
    return m_run.timeline().script().step.isAdaptive();
}

void StepMenu::follow()
{
    const sim::StepSize &step = m_run.timeline().script().step;
    const bool adaptive = step.isAdaptive();
    const double value = adaptive ? step.tolerance : step.h;
    for (QAction *action : actions()) {
        if (!action->isCheckable())
            continue;
        const bool fits = action->property(tolerance).toBool() == adaptive;
        action->setVisible(fits);
        action->setChecked(fits && std::abs(action->data().toDouble() / value - 1.0) < 1e-9);
    }
    m_unit->setText(adaptive ? tr("px") : tr("frames"));
    m_other->setPlaceholderText(adaptive ? QStringLiteral("5e-3") : QStringLiteral("1/6"));
    m_other->setToolTip(
        adaptive ? tr("From 1e-13 to 100 px; press Enter to apply")
                 : tr("A whole number of frames, or 1 divided by a whole number; press Enter to apply"));
    m_other->setAccessibleName(adaptive ? tr("Other tolerance, in px") : tr("Other step, in frames"));
}

void StepMenu::explain(const QString &why)
{
    const int width = m_other->parentWidget()->width();
    m_why->setText(why);
    m_why->setFixedSize(width, m_why->heightForWidth(width));
    m_whyEntry->setVisible(false); // so that the menu takes the new height
    m_whyEntry->setVisible(true);
}

void StepMenu::takeOther()
{
    const double typed = stepFromText(m_other->text());
    if (typed == 0.0) { // not a number
        explain(m_other->toolTip());
        return;
    }
    const bool adaptive = isAdaptive();
    try {
        adaptive ? sim::StepSize::withTolerance(typed) : sim::StepSize::ofLength(typed);
    } catch (const sim::Error &error) {
        explain(sentenceFor(error));
        return;
    }
    close();
    adaptive ? m_editor.setTolerance(typed) : m_editor.setStepSize(typed);
}

}
