package faultline.gui.properties;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.geometry.Pose;
import faultline.geometry.Vector2;
import faultline.gui.Await;
import faultline.gui.BackgroundThreads;
import faultline.gui.ComponentFinder;
import faultline.gui.EdtChecker;
import faultline.gui.form.FormDialog;
import faultline.gui.text.Language;
import faultline.gui.text.Messages;
import faultline.gui.theme.Theme;
import faultline.paint.surface.Palette;
import faultline.scenario.Scenario;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.ImageIcon;
import javax.swing.JCheckBox;
import javax.swing.JFormattedTextField;
import javax.swing.JLabel;
import javax.swing.JSpinner;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The import of a floor plan of 60 by 40 cells: a room with a box of 5 by 5 cells and a speck. */
@ExtendWith(EdtChecker.class)
class ImportFormTest {

    private static final int WIDTH = 60;
    private static final int HEIGHT = 40;

    @TempDir
    private Path folder;

    private Path image;

    @BeforeEach
    void write() throws IOException {
        runOnEdt(Theme.LIGHT::install);
        StringBuilder text = new StringBuilder("P2\n" + WIDTH + " " + HEIGHT + "\n255\n");
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                boolean wall = x == 0 || y == 0 || x == WIDTH - 1 || y == HEIGHT - 1;
                boolean box = x >= 10 && x < 15 && y >= 8 && y < 13;
                text.append(wall || box || x == 40 && y == 20 ? "0 " : "254 ");
            }
            text.append('\n');
        }
        image = Files.writeString(folder.resolve("hall.pgm"), text);
    }

    @AfterEach
    void setEnglish() {
        Messages.setLanguage(Language.ENGLISH);
    }

    private static void awaitStatus(ImportForm form, String start) {
        Await.until("the status \"" + start + "\"", () -> form.status().startsWith(start));
    }

    @Test
    void theImageIsReadWithEachChangeOfAField() {
        ImportForm form = callOnEdt(() -> new ImportForm(image));
        awaitStatus(form, "Cells: 60 × 40 (3.00 × 2.00 m), outlines: 4");
        Scenario small = callOnEdt(() -> form.scenario().orElseThrow());
        assertEquals(3, small.setup().world().width(), 1e-9);
        runOnEdt(() -> ComponentFinder.find(form, JSpinner.class, "Smallest wall, cells")
                .setValue(2.0));
        awaitStatus(form, "Cells: 60 × 40 (3.00 × 2.00 m), outlines: 3");
        runOnEdt(() ->
                ComponentFinder.find(form, JSpinner.class, "Side of a pixel, m").setValue(0.1));
        Await.until("the larger plan", () -> form.scenario()
                .filter(read -> Math.abs(read.setup().world().width() - 6) < 1e-9)
                .isPresent());
        assertTrue(callOnEdt(
                () -> ComponentFinder.find(form, JLabel.class, "Preview").getIcon() != null));
        assertEquals("hall", callOnEdt(() -> form.scenario().orElseThrow().name()));
    }

    @Test
    void aKeyOfAMapThatMayBeMisspeltIsNotedBelowThePreview() throws IOException {
        Path map = folder.resolve("hall.yaml");
        Files.writeString(map, "image: hall.pgm\nresolution: 0.05\nnegat: 1\nsensor: x\n");
        ImportForm form = callOnEdt(() -> new ImportForm(map));
        awaitStatus(form, "Cells: 60 × 40");
        assertEquals(
                List.of("\"negat\" is not a key of maps and is ignored; did you mean \"negate\"?"),
                form.status().lines().skip(1).toList());
        assertTrue(callOnEdt(() -> form.scenario().isPresent()));
    }

    /** A large plan takes seconds and much memory, and an arrow of a field that is held down changes it often. */
    @Test
    void aPlanIsReadOnceAtATime() throws IOException {
        int side = 1500;
        byte[] pixels = new byte[side * side];
        Arrays.fill(pixels, (byte) 254);
        Arrays.fill(pixels, 0, side, (byte) 0);
        Path large = folder.resolve("large.pgm");
        Files.write(large, ("P5 " + side + " " + side + " 255\n").getBytes(StandardCharsets.US_ASCII));
        Files.write(large, pixels, StandardOpenOption.APPEND);
        BackgroundThreads.awaitEnd();
        ImportForm form = callOnEdt(() -> {
            ImportForm opened = new ImportForm(large);
            JSpinner resolution = ComponentFinder.find(opened, JSpinner.class, "Side of a pixel, m");
            for (int i = 1; i <= 10; i++) {
                resolution.setValue(0.01 * i);
            }
            assertEquals(1, BackgroundThreads.count());
            return opened;
        });
        Await.until("the newest plan", () -> form.scenario().isPresent());
        assertEquals(
                150,
                callOnEdt(() -> form.scenario().orElseThrow().setup().world().width()),
                1e-9);
    }

    @Test
    void theStartIsChosenWithinFreeSpace() {
        ImportForm form = callOnEdt(() -> new ImportForm(image));
        awaitStatus(form, "Cells: 60 × 40");
        Pose found = callOnEdt(() -> form.scenario().orElseThrow().setup().start());
        JSpinner x = callOnEdt(() -> ComponentFinder.find(form, JSpinner.class, "Start x, m"));
        assertEquals(found.x(), callOnEdt(x::getValue));
        assertFalse(callOnEdt(x::isEnabled));
        runOnEdt(() -> {
            ComponentFinder.find(form, JCheckBox.class, "Start in the largest free space")
                    .doClick();
            x.setValue(0.5);
            ComponentFinder.find(form, JSpinner.class, "Start y, m").setValue(0.5);
            ComponentFinder.find(form, JSpinner.class, "Start heading, °").setValue(90.0);
        });
        Await.until("the chosen start", () -> form.scenario()
                .filter(read -> read.setup().start().equals(new Pose(0.5, 0.5, Math.PI / 2)))
                .isPresent());
        runOnEdt(() -> x.setValue(0.06));
        awaitStatus(form, "The robot cannot start there");
        assertEquals(Optional.empty(), callOnEdt(form::scenario));
        assertTrue(callOnEdt(
                () -> ComponentFinder.find(form, JLabel.class, "Preview").getIcon() != null));
    }

    /** The picture shows 3 by 2 m with the same margin on the left and on the right, above and below. */
    @Test
    void aDragInThePreviewPlacesTheStart() {
        ImportForm form = callOnEdt(() -> new ImportForm(image));
        awaitStatus(form, "Cells: 60 × 40");
        JLabel picture = callOnEdt(() -> ComponentFinder.find(form, JLabel.class, "Preview"));
        runOnEdt(() -> {
            picture.setSize(picture.getPreferredSize().width + 40, picture.getPreferredSize().height + 20);
            int x = picture.getWidth() / 2;
            int y = picture.getHeight() / 2;
            press(picture, MouseEvent.MOUSE_PRESSED, x - 50, y);
            press(picture, MouseEvent.MOUSE_DRAGGED, x, y);
            assertEquals(
                    1.5,
                    (double) ComponentFinder.find(form, JSpinner.class, "Start x, m")
                            .getValue(),
                    0.01);
            press(picture, MouseEvent.MOUSE_RELEASED, x, y);
            assertTrue(ComponentFinder.find(form, JSpinner.class, "Start y, m").isEnabled());
            assertFalse(ComponentFinder.find(form, JCheckBox.class, "Start in the largest free space")
                    .isSelected());
        });
        Await.until("the start in the middle", () -> form.scenario()
                .filter(read -> read.setup().start().position().distanceTo(new Vector2(1.5, 1)) < 0.02)
                .isPresent());
    }

    private static void press(JLabel picture, int kind, int x, int y) {
        picture.dispatchEvent(
                new MouseEvent(picture, kind, 0, InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON1));
    }

    @Test
    void aMapGivesItsOwnResolution() throws IOException {
        Path map = Files.writeString(
                folder.resolve("hall.yaml"),
                "image: hall.pgm\nresolution: 0.08\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\n"
                        + "free_thresh: 0.196\n");
        ImportForm form = callOnEdt(() -> new ImportForm(map));
        awaitStatus(form, "Cells: 60 × 40");
        assertEquals(
                4.8,
                callOnEdt(() -> form.scenario().orElseThrow().setup().world().width()),
                1e-9);
        assertFalse(callOnEdt(() -> ComponentFinder.findAll(form, JSpinner.class)
                .anyMatch(field -> ComponentFinder.accessibleName(field).equals("Side of a pixel, m"))));
    }

    private Path writeLightWalls() throws IOException {
        String light = Stream.of(Files.readString(image).split("\\s+"))
                .skip(4)
                .map(value -> value.equals("0") ? "200" : "0")
                .collect(Collectors.joining(" "));
        return Files.writeString(folder.resolve("white.pgm"), "P2 60 40 255\n" + light);
    }

    @Test
    void anImageWithLightWallsIsImported() throws IOException {
        Path white = writeLightWalls();
        ImportForm form = callOnEdt(() -> new ImportForm(white));
        awaitStatus(
                form,
                "The robot, 0.25 m long and 0.2 m wide, has no room in the free space of this map of 3 x 2 m;"
                        + " what may help: \"Side of a pixel, m\", \"Light pixels are walls\","
                        + " \"Wall threshold, 0 to 1\", \"Unknown cells are walls\","
                        + " or a start without \"Start in the largest free space\"");
        runOnEdt(() -> ComponentFinder.find(form, JCheckBox.class, "Light pixels are walls")
                .doClick());
        awaitStatus(form, "Cells: 60 × 40 (3.00 × 2.00 m), outlines: 4");
        runOnEdt(() -> ComponentFinder.find(form, JSpinner.class, "Wall threshold, 0 to 1")
                .setValue(0.9));
        awaitStatus(form, "Cells: 60 × 40 (3.00 × 2.00 m), outlines: 0");
    }

    /** The outlines show which setting is wrong, and where the robot could start. */
    @Test
    void aPlanWithoutRoomIsShownWithoutARobot() throws IOException {
        Path white = writeLightWalls();
        ImportForm form = callOnEdt(() -> new ImportForm(white));
        awaitStatus(form, "The robot, 0.25 m long and 0.2 m wide, has no room");
        JLabel picture = callOnEdt(() -> ComponentFinder.find(form, JLabel.class, "Preview"));
        BufferedImage shown = callOnEdt(() -> (BufferedImage) ((ImageIcon) picture.getIcon()).getImage());
        Set<Integer> colours = Arrays.stream(
                        shown.getRGB(0, 0, shown.getWidth(), shown.getHeight(), null, 0, shown.getWidth()))
                .boxed()
                .collect(Collectors.toSet());
        assertTrue(colours.contains(Palette.LIGHT.obstacle().getRGB()));
        assertFalse(colours.contains(Palette.LIGHT.robot().getRGB()));
        runOnEdt(() -> {
            picture.setSize(picture.getPreferredSize());
            press(picture, MouseEvent.MOUSE_PRESSED, picture.getWidth() / 2, picture.getHeight() / 2);
            press(picture, MouseEvent.MOUSE_RELEASED, picture.getWidth() / 2, picture.getHeight() / 2);
        });
        awaitStatus(form, "The robot cannot start there");
    }

    @Test
    void aMapFileWithoutRoomNamesItsKeys() throws IOException {
        Files.writeString(folder.resolve("tiny.pgm"), "P2 2 2 255 9 255 255 9");
        Path map = Files.writeString(folder.resolve("tiny.yaml"), "image: tiny.pgm\nresolution: 0.05\n");
        ImportForm form = callOnEdt(() -> new ImportForm(map));
        awaitStatus(form, folder.resolve("tiny.pgm") + ": the robot, 0.25 m long and 0.2 m wide, has no room");
        assertTrue(
                form.status()
                        .endsWith("what may help: resolution, occupied_thresh and negate in the map file,"
                                + " \"Unknown cells are walls\", or a start without"
                                + " \"Start in the largest free space\""),
                form.status());
        assertFalse(callOnEdt(() -> ComponentFinder.findAll(form, JCheckBox.class)
                .anyMatch(box -> box.getText().equals("Light pixels are walls"))));
    }

    @Test
    void aFileThatIsNoPlanGivesASentence() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.pgm"), "P5\nhello");
        ImportForm form = callOnEdt(() -> new ImportForm(broken));
        Await.until("a sentence", () -> !form.status().startsWith("Reading"));
        assertTrue(callOnEdt(() -> form.scenario().isEmpty() && form.status().length() > 10), form.status());
    }

    /** With a field that cannot mend a broken file, the user would only read it again. */
    @ParameterizedTest
    @CsvSource({
        "broken.pgm, P5 hello, false",
        "broken.png, hello, false",
        "broken.yaml, resolution: 1, false",
        "tiny.pgm, P2 2 2 255 9 255 255 9, true"
    })
    void onlyAProblemThatTheFieldsCanMendLeavesThemEnabled(String name, String content, boolean enabled)
            throws IOException {
        Path plan = Files.writeString(folder.resolve(name), content);
        ImportForm form = callOnEdt(() -> new ImportForm(plan));
        Await.until("a sentence", () -> !form.status().startsWith("Reading"));
        JSpinner smallest = callOnEdt(() -> ComponentFinder.find(form, JSpinner.class, "Smallest wall, cells"));
        assertEquals(enabled, callOnEdt(smallest::isEnabled), form::status);
        assertEquals(enabled, callOnEdt(() -> ComponentFinder.find(form, JCheckBox.class, "Unknown cells are walls")
                .isEnabled()));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            broken.pgm  | P5 hello               | W bajcie 3 zamiast szerokości jest "hello"; dozwolone: liczba całkowita
            broken.png  | hello                  | Format obrazu nie jest obsługiwany; dozwolone: PGM (P2, P5), PNG, BMP, GIF lub TIFF
            broken.yaml | resolution: fast       | FILE:1:1: brakuje "image"; plik mapy musi to zawierać
            broken.yaml | {image: a, mode: trinar, resolution: 1} | FILE:1:18: mode to "trinar"; dozwolone: trinary, scale, raw; czy chodziło o "trinary"?
            tiny.pgm    | P2 2 2 255 9 255 255 9 | Robot o długości 0.25 m i szerokości 0.2 m nie mieści się w wolnym miejscu tej mapy o wymiarach 0.1 x 0.1 m; może pomóc: "Bok piksela, m", "Jasne piksele to ściany", "Próg ściany, od 0 do 1", "Nieznane komórki to ściany" lub start bez opcji "Start w największym wolnym miejscu"
            """)
    void aBrokenPlanIsReportedInPolish(String name, String content, String sentence) throws IOException {
        Messages.setLanguage(Language.POLISH);
        Path broken = Files.writeString(folder.resolve(name), content);
        ImportForm form = callOnEdt(() -> new ImportForm(broken));
        Await.until("a sentence", () -> !form.status().startsWith("Czytanie"));
        assertEquals(sentence.replace("FILE", broken.toString()), callOnEdt(form::status));
    }

    @Test
    void aLongSentenceDoesNotWidenTheForm() throws IOException {
        Path map = Files.writeString(
                folder.resolve("m".repeat(150) + ".yaml"), "image: " + "i".repeat(150) + ".png\nresolution: 0.1\n");
        ImportForm form = callOnEdt(() -> new ImportForm(map));
        int width = callOnEdt(() -> form.getPreferredSize().width);
        Await.until("a sentence", () -> !form.status().startsWith("Reading"));
        assertTrue(form.status().length() > 300, form.status());
        assertEquals(width, callOnEdt(() -> form.getPreferredSize().width));
    }

    @Test
    void theFormBecomesNarrowAgain() {
        ImportForm form = callOnEdt(() -> new ImportForm(image));
        awaitStatus(form, "Cells: 60 × 40");
        int width = callOnEdt(() -> form.getPreferredSize().width);
        assertEquals(width, callOnEdt(() -> {
            form.setSize(width + 30, 600);
            ComponentFinder.layOut(form);
            return form.getPreferredSize().width;
        }));
    }

    @Test
    void aNumberThatIsBeingTypedIsUsedOrRefused() {
        ImportForm form = callOnEdt(() -> new ImportForm(image));
        awaitStatus(form, "Cells: 60 × 40 (3.00 × 2.00 m), outlines: 4");
        JFormattedTextField smallest = callOnEdt(
                () -> ((JSpinner.DefaultEditor) ComponentFinder.find(form, JSpinner.class, "Smallest wall, cells")
                                .getEditor())
                        .getTextField());
        for (String wrong : List.of("-7", "1.5")) {
            runOnEdt(() -> smallest.setText(wrong));
            assertEquals(
                    wrong + " is not allowed. Smallest wall, cells: whole numbers, 1 to 100000",
                    callOnEdt(() -> FormDialog.describeRefusedNumber(form))
                            .orElseThrow()
                            .sentence());
        }
        assertTrue(callOnEdt(() -> {
            smallest.setText("2");
            return FormDialog.describeRefusedNumber(form).isEmpty()
                    && form.scenario().isEmpty();
        }));
        awaitStatus(form, "Cells: 60 × 40 (3.00 × 2.00 m), outlines: 3");
    }

    @Test
    void plansAreKnownByTheirEndings() {
        assertTrue(FloorPlanFiles.isFloorPlan(Path.of("Willow.YAML")));
        assertTrue(FloorPlanFiles.isFloorPlan(Path.of("a.b/floor.png")));
        assertFalse(FloorPlanFiles.isFloorPlan(Path.of("office.xml")));
    }
}
