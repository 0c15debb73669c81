// SPDX-License-Identifier: GPL-3.0-or-later
#include "edgeproof/report/page/parts_page.hpp"

#include "edgeproof/report/page/html.hpp"
#include "edgeproof/report/text/escape.hpp"

namespace edgeproof::report {

std::string parts_page(const std::string& title, const std::string& about,
                       const std::vector<PagePart>& parts, bool labelled,
                       const std::string& footer) {
    std::string contents;
    std::string body;
    for (const PagePart& part : parts) {
        const std::string id = escape_html(part.id);
        contents += part.listed.empty()
                        ? ""
                        : "<li><a href=\"#" + id + "\">" + escape_html(part.listed) + "</a></li>\n";
        body += "<section id=\"" + id + '"' +
                (labelled ? " aria-labelledby=\"" + id + "-title\"" : "") + ">\n<h2" +
                (labelled ? " id=\"" + id + "-title\"" : "") + '>' + escape_html(part.title) +
                "</h2>\n" + part.html + "</section>\n";
    }
    return fill_template(cost_template::cost_html, {{"title", escape_html(title)},
                                                    {"css", std::string(report_template::page_css)},
                                                    {"machine", escape_html(about)},
                                                    {"contents", contents},
                                                    {"parts", body},
                                                    {"footer", escape_html(footer)}});
}

} // namespace edgeproof::report
