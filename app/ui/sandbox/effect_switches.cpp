#include "app/ui/sandbox/effect_switches.h"

#include "app/model/text/sentences.h"
#include "sim/effects/all_effects.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QSignalBlocker>

namespace app {

namespace {

constexpr int switchMargin = 16;
constexpr int switchColumns = 2;

}

EffectSwitches::EffectSwitches(const OpenRun &run, SandboxEditor &editor, QWidget *parent)
    : QWidget(parent), m_run(run), m_editor(editor)
{
    connect(&editor, &SandboxEditor::changed, this, &EffectSwitches::refresh);
    run.onChange(ChangeKind::step, this, &EffectSwitches::make);
    run.onChange(ChangeKind::run, this, &EffectSwitches::refresh);
    make();
}

void EffectSwitches::make()
{
    m_switches.clear();
    delete layout();
    qDeleteAll(findChildren<QCheckBox *>(Qt::FindDirectChildrenOnly));
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(switchMargin, 2, switchMargin, 4);
    grid->setSpacing(6);
    int place = 0;
    for (const sim::EffectDescription *effect : m_run.step().availableEffects) {
        const QString id = QString::fromUtf8(effect->id);
        auto *box = new QCheckBox(capitalised(phrase(effect->title)), this);
        box->setToolTip(phrase(effect->purpose));
        box->setAccessibleDescription(box->toolTip());
        box->setFocusPolicy(Qt::TabFocus);
        connect(box, &QCheckBox::clicked, this, [this, id](bool on) {
            m_editor.setEffect(id, on);
            refresh(); // the change may have been rejected
        });
        grid->addWidget(box, place / switchColumns, place % switchColumns);
        m_switches[id] = box;
        ++place;
    }
    refresh();
}

QCheckBox *EffectSwitches::box(const QString &effect) const
{
    const auto found = m_switches.find(effect);
    return found == m_switches.end() ? nullptr : found->second;
}

void EffectSwitches::refresh()
{
    if (!m_editor.isOpen())
        return;
    for (const auto &[id, box] : m_switches) {
        const QSignalBlocker silent(box);
        box->setChecked(m_editor.has(id));
    }
}

}
