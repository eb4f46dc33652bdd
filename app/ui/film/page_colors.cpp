#include "app/ui/film/page_colors.h"

#include "app/ui/scene/layers/sky.h"

namespace app {

PageColors pageColors(Scheme scheme)
{
    const Theme theme(scheme);
    const Tokens &t = theme.tokens();
    const SkyColors sky = skyColors(scheme);
    const std::pair<const char *, QColor> all[] = {
        {"win", t.win},
        {"ctl", t.ctl},
        {"panel", t.panel},
        {"scene", t.scene},
        {"sunk", t.sunk},
        {"hover", t.hover},
        {"line", t.line},
        {"line2", t.line2},
        {"ink", t.ink},
        {"ink2", t.ink2},
        {"ink3", t.ink3},
        {"button", t.button},
        {"buttonText", t.buttonText},
        {"now", t.now},
        {"link", t.link},
        {"near", t.near},
        {"past", t.past},
        {"body", t.body},
        {"bodyInk", t.bodyInk},
        {"ghost", t.ghost},
        {"dots", t.dots},
        {"keyword", t.keyword},
        {"number", t.number},
        {"type", t.type},
        {"comment", t.comment},
        {"chip", t.chip},
        {"spring", t.spring},
        {"contact", t.contact},
        {"wind", t.wind},
        {"stick", t.stick},
        {"rule", t.rule},
        {"sky0", sky.sky[0]},
        {"sky1", sky.sky[1]},
        {"sky2", sky.sky[2]},
        {"sky3", sky.sky[3]},
        {"sky4", sky.sky[4]},
        {"meadow", sky.meadow},
        {"bark", sky.bark},
        {"twigs", sky.twigs},
        {"blossom0", sky.blossoms[0]},
        {"blossom1", sky.blossoms[1]},
        {"blossom2", sky.blossoms[2]},
    };
    PageColors colors;
    for (const auto &[name, color] : all)
        colors.emplace_back(QString::fromLatin1(name), color.name());
    return colors;
}

}
