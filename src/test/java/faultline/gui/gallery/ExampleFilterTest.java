package faultline.gui.gallery;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.scenario.ShippedScenarios;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** The groups and the search of the gallery, with titles made of the files' names. */
class ExampleFilterTest {

    private final ExampleFilter filter = new ExampleFilter();

    private void addAll() throws IOException {
        for (String file : ShippedScenarios.names()) {
            String title = file.replace(".xml", "").replace('-', ' ').toUpperCase(Locale.ROOT);
            filter.add(new Example(file, title, "", new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB)));
        }
    }

    private List<String> shown() {
        return Collections.list(filter.shown().elements()).stream()
                .map(Example::file)
                .toList();
    }

    @Test
    void everyExampleIsInExactlyOneGroup() throws IOException {
        addAll();
        List<String> grouped = Stream.of(ExampleGroup.values())
                .filter(group -> group != ExampleGroup.ALL)
                .flatMap(group -> {
                    filter.setGroup(group);
                    return shown().stream();
                })
                .sorted()
                .toList();
        assertEquals(ShippedScenarios.names(), grouped);
    }

    @Test
    void everyFileOfAGroupShips() throws IOException {
        addAll();
        filter.setGroup(ExampleGroup.FAULT_STORIES);
        assertEquals(3, shown().size());
        filter.setGroup(ExampleGroup.MOVING);
        assertEquals(4, shown().size());
        filter.setGroup(ExampleGroup.FAULTS);
        assertEquals(5, shown().size());
    }

    @Test
    void theSearchFindsTheNamesOfGroups() throws IOException {
        addAll();
        filter.setText("fault");
        assertTrue(shown().containsAll(Arrays.asList("front-sensor-dies.xml", "left-sensor-off.xml", "mirror.xml")));
    }

    @Test
    void theSearchIgnoresCapitalsAndKeepsTheGroup() throws IOException {
        filter.setText(" corner ");
        addAll();
        assertTrue(shown().size() >= 6, "also those that are loaded later");
        filter.setGroup(ExampleGroup.MOVING);
        assertEquals(List.of(), shown());
        filter.setText("Visitor");
        assertTrue(shown().containsAll(Arrays.asList("three-visitors.xml", "struck-by-a-visitor.xml")));
        filter.setText("");
        filter.setGroup(ExampleGroup.ALL);
        assertEquals(ShippedScenarios.names(), shown());
    }
}
