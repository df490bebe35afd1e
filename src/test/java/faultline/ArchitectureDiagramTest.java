package faultline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** The picture of the layers shows the packages as they are. */
class ArchitectureDiagramTest {

    @Test
    void theCheckedInPictureIsUpToDate() throws IOException {
        assertTrue(
                Files.readString(Path.of("docs/architecture.svg"))
                        .equals(ArchitectureDiagram.draw(PackageGraph.read(PackageGraph.compiledClasses()))),
                "the dependencies of a package have changed; src/conf/architecture draws the picture again");
    }

    @Test
    void aPackageStandsAboveAllThatItUses() {
        DiagramLayout layout = new DiagramLayout(
                Map.of("b", Set.of("a"), "c", Set.of("a", "b"), "d", Set.of("a")), List.of("a", "b", "c", "d"), 400);
        assertEquals(List.of("c"), names(layout, 0));
        assertEquals(List.of("b", "d"), names(layout, 1));
        assertEquals(List.of("a"), names(layout, 2));
        assertEquals(3, layout.edges().size(), "a line from c to a follows from the others");
    }

    @Test
    void boxesDoNotOverlapAndLieInThePicture() {
        DiagramLayout layout = new DiagramLayout(
                PackageGraph.read(PackageGraph.compiledClasses()), LayerRules.PACKAGE_ORDER, ArchitectureDiagram.WIDTH);
        for (List<DiagramLayout.Node> row : layout.rows()) {
            List<DiagramLayout.Node> overlapping = IntStream.range(1, row.size())
                    .filter(i -> left(row.get(i)) < right(row.get(i - 1)))
                    .mapToObj(row::get)
                    .toList();
            assertEquals(List.of(), overlapping);
            assertTrue(left(row.get(0)) >= 0 && right(row.get(row.size() - 1)) <= ArchitectureDiagram.WIDTH);
        }
    }

    private static double left(DiagramLayout.Node node) {
        return node.x() - node.width() / 2.0;
    }

    private static double right(DiagramLayout.Node node) {
        return node.x() + node.width() / 2.0;
    }

    private static List<String> names(DiagramLayout layout, int row) {
        return layout.rows().get(row).stream()
                .filter(node -> !node.isBend())
                .map(DiagramLayout.Node::name)
                .sorted()
                .toList();
    }
}
