package faultline.campaign.report;

import faultline.io.DecimalText;
import faultline.io.XmlText;
import faultline.paint.surface.SvgTheme;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Locale;

/** Pieces of HTML. */
final class Html {

    private Html() {}

    static String escape(String text) {
        return XmlText.escapeAttribute(text);
    }

    static String format(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }

    /** Returns a self-contained page. */
    static String page(String title, String introduction, String content) {
        return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>"
                + escape(title) + "</title>\n<style>\n" + styleSheet()
                + SvgTheme.styleSheet(content) + "\n</style>\n</head>\n<body>\n<header>\n<h1>" + escape(title)
                + "</h1>\n" + paragraph(introduction)
                + "</header>\n<main>\n" + content + "</main>\n</body>\n</html>\n";
    }

    private static String styleSheet() {
        try (InputStream in = Html.class.getResourceAsStream("report.css")) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Returns a section with a heading. */
    static String section(String title, String content) {
        return "<section>\n<h2>" + escape(title) + "</h2>\n" + content + "</section>\n";
    }

    static String paragraph(String text) {
        return "<p>" + escape(text) + "</p>\n";
    }

    /** Returns a table of cells that are given as HTML. */
    static String table(String css, List<String> header, List<List<String>> rows) {
        StringBuilder out = new StringBuilder("<div class=\"scroll\"><table class=\"" + css + "\">\n<thead><tr>");
        header.forEach(cell -> out.append("<th scope=\"col\">").append(cell).append("</th>"));
        out.append("</tr></thead>\n<tbody>\n");
        for (List<String> row : rows) {
            out.append("<tr><th scope=\"row\">").append(row.get(0)).append("</th>");
            row.stream().skip(1).forEach(cell -> out.append(cell.startsWith("<td") ? cell : "<td>" + cell + "</td>"));
            out.append("</tr>\n");
        }
        return out.append("</tbody></table></div>\n").toString();
    }

    /** Returns a number with its noun, given in the singular. */
    static String count(long number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }

    /** Returns a share in per cent. */
    static String percent(double share) {
        return Survival.percentText(share) + "&thinsp;%";
    }

    /** Returns a share with its interval and number of runs. */
    static String survival(Survival survival) {
        if (survival.n() == 0) {
            return "&ndash;";
        }
        return "<b>" + percent(survival.share()) + "</b> " + interval(survival);
    }

    private static String interval(Survival survival) {
        return format(
                "<small>%s&ndash;%s; n %d</small>",
                Survival.percentText(survival.interval().low()),
                Survival.percentText(survival.interval().high()),
                survival.n());
    }

    /** Returns a cell with a share, coloured by it. */
    static String survivalCell(Survival survival) {
        if (survival.n() == 0) {
            return "<td class=\"empty\">&ndash;</td>";
        }
        String colour = survival.share() >= 0.5
                ? format("rgba(0,150,160,%.2f)", (survival.share() - 0.5) * 0.9)
                : format("rgba(225,110,0,%.2f)", (0.5 - survival.share()) * 0.9);
        return "<td style=\"background:" + colour + "\"><b>" + percent(survival.share()) + "</b>"
                + ReportCharts.intervalBar(survival) + interval(survival) + "</td>";
    }

    /** Returns a number to three digits. */
    static String number(double value) {
        return Double.isFinite(value) ? DecimalText.formatRounded(value) : "&ndash;";
    }
}
