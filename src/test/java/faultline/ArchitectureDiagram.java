package faultline;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Draws {@code docs/architecture.svg}: the packages in layers, by the declared order and the dependencies that
 * {@code jdeps} finds. {@code src/conf/architecture} runs it.
 */
final class ArchitectureDiagram {

    private static final int ROW_HEIGHT = 46;
    private static final int BOX_HEIGHT = 26;
    private static final int TOP = 56;
    static final int WIDTH = 1280;

    /** A group of packages that is drawn in one colour. */
    private record Group(String style, String label, List<String> prefixes) {}

    private static final List<Group> GROUPS = List.of(
            new Group("front", "front ends", List.of("app", "studies", "campaign")),
            new Group("gui", "window", List.of("gui")),
            new Group("paint", "painting", List.of("paint")),
            new Group("files", "files", List.of("scenario", "floorplan")),
            new Group("model", "model", List.of("")));

    private static final String STYLE =
            """
            <style>
            text { font: 13px sans-serif; fill: #1c2733; text-anchor: middle; }
            .index { font-size: 9px; text-anchor: end; fill: #5a6773; }
            rect { stroke: #5a6773; }
            .page { fill: #ffffff; stroke: none; }
            path { fill: none; stroke: #8b98a5; }
            .front { fill: #f3ddc2; } .gui { fill: #d5e5f7; } .paint { fill: #dcefd6; }
            .files { fill: #efe3f5; } .model { fill: #f4f0c9; }
            @media (prefers-color-scheme: dark) {
            text { fill: #e6edf3; } .index { fill: #9aa7b4; } .page { fill: #0d1117; }
            .front { fill: #5a4326; } .gui { fill: #24405e; } .paint { fill: #2c4a25; }
            .files { fill: #4a3357; } .model { fill: #4c4820; }
            }
            </style>
            """;

    private final DiagramLayout layout;
    private final StringBuilder svg = new StringBuilder();

    private ArchitectureDiagram(Map<String, Set<String>> uses) {
        layout = new DiagramLayout(uses, LayerRules.PACKAGE_ORDER, WIDTH);
    }

    /**
     * Writes the diagram.
     *
     * @param arguments the file to write
     * @throws IOException if it cannot be written
     */
    public static void main(String[] arguments) throws IOException {
        Files.writeString(Path.of(arguments[0]), draw(PackageGraph.read(PackageGraph.compiledClasses())));
    }

    /**
     * Returns the diagram as SVG.
     *
     * @param uses what each package uses
     */
    static String draw(Map<String, Set<String>> uses) {
        return new ArchitectureDiagram(uses).draw();
    }

    private String draw() {
        int height = TOP + layout.rows().size() * ROW_HEIGHT;
        add(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\">",
                WIDTH, height, WIDTH, height);
        add("<title>The packages of Faultline, in layers</title>");
        svg.append(STYLE);
        add("<rect class=\"page\" width=\"%d\" height=\"%d\"/>", WIDTH, height);
        addLegend();
        layout.edges().forEach(this::addEdge);
        for (int row = 0; row < layout.rows().size(); row++) {
            for (DiagramLayout.Node node : layout.rows().get(row)) {
                addBox(node, row);
            }
        }
        add("</svg>");
        return svg.toString();
    }

    private void addLegend() {
        for (int i = 0; i < GROUPS.size(); i++) {
            int x = 20 + i * WIDTH / GROUPS.size();
            add(
                    "<rect class=\"%s\" x=\"%d\" y=\"12\" width=\"20\" height=\"14\"/>",
                    GROUPS.get(i).style(), x);
            add(
                    "<text x=\"%d\" y=\"24\" style=\"text-anchor: start\">%s</text>",
                    x + 28, GROUPS.get(i).label());
        }
    }

    private void addBox(DiagramLayout.Node node, int row) {
        if (node.isBend()) {
            return;
        }
        double x = node.x();
        int y = top(row);
        add(
                "<rect class=\"%s\" x=\"%.1f\" y=\"%d\" width=\"%d\" height=\"%d\" rx=\"4\"/>",
                style(node.name()), x - node.width() / 2.0, y, node.width(), BOX_HEIGHT);
        add("<text x=\"%.1f\" y=\"%d\">%s</text>", x - 4, y + 17, node.name());
        add(
                "<text class=\"index\" x=\"%.1f\" y=\"%d\">%d</text>",
                x + node.width() / 2.0 - 3, y + 10, LayerRules.PACKAGE_ORDER.indexOf(node.name()) + 1);
    }

    private void addEdge(List<DiagramLayout.Node> nodes) {
        StringBuilder path = new StringBuilder();
        for (int i = 0; i < nodes.size(); i++) {
            DiagramLayout.Node node = nodes.get(i);
            int top = top(node.row());
            if (i > 0) {
                double before = nodes.get(i - 1).x();
                int from = top - ROW_HEIGHT + BOX_HEIGHT;
                int middle = (from + top) / 2;
                path.append(text(" C%.1f %d %.1f %d %.1f %d", before, middle, node.x(), middle, node.x(), top));
            }
            path.append(text(i == 0 ? "M%.1f %d" : " L%.1f %d", node.x(), top + BOX_HEIGHT));
        }
        int end = path.lastIndexOf(" L");
        add("<path d=\"%s\"/>", path.substring(0, end));
    }

    private static int top(int row) {
        return TOP + row * ROW_HEIGHT;
    }

    private static String style(String name) {
        return GROUPS.stream()
                .filter(group -> group.prefixes().stream().anyMatch(name::startsWith))
                .findFirst()
                .orElseThrow()
                .style();
    }

    private void add(String format, Object... values) {
        svg.append(text(format, values)).append('\n');
    }

    private static String text(String format, Object... values) {
        return String.format(Locale.ROOT, format, values);
    }
}
