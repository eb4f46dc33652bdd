#include "app/ui/sandbox/effect_switches.h"

#include "app/model/sentences.h"
#include "sim/effects/all_effects.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QSignalBlocker>

namespace app {

namespace {

constexpr int sideMargin = 16;
constexpr int columns = 2;

}

EffectSwitches::EffectSwitches(Session &session, Workbench &bench, QWidget *parent)
    : QWidget(parent), m_session(session), m_bench(bench)
{
    connect(&bench, &Workbench::changed, this, &EffectSwitches::refresh);
    connect(&session, &Session::stepOpened, this, &EffectSwitches::make);
    connect(&session, &Session::runChanged, this, &EffectSwitches::refresh);
    make();
}

void EffectSwitches::make()
{
    m_switches.clear();
    delete layout();
    qDeleteAll(findChildren<QCheckBox *>(Qt::FindDirectChildrenOnly));
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(sideMargin, 2, sideMargin, 4);
    grid->setSpacing(6);
    int place = 0;
    for (const sim::EffectDescription *effect : m_session.step().availableEffects) {
        const QString id = QString::fromUtf8(effect->id);
        auto *box = new QCheckBox(capitalised(phrase(effect->title)), this);
        box->setToolTip(phrase(effect->purpose));
        box->setAccessibleDescription(box->toolTip());
        connect(box, &QCheckBox::clicked, this, [this, id](bool on) {
            m_bench.setEffect(id, on);
            refresh(); // it may not have been the time for it
        });
        grid->addWidget(box, place / columns, place % columns);
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
    if (!m_bench.isOpen())
        return;
    for (const auto &[id, box] : m_switches) {
        const QSignalBlocker silent(box);
        box->setChecked(m_bench.has(id));
    }
}

}
