package faultline.gui.window;

import static faultline.gui.GuiRobot.edt;
import static faultline.gui.GuiRobot.onEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.engine.Frame;
import faultline.engine.SampleFrames;
import faultline.engine.Session;
import faultline.gui.Components;
import faultline.gui.action.UiAction;
import faultline.gui.canvas.SimulationCanvas;
import faultline.gui.document.Bench;
import faultline.gui.document.BenchListener;
import faultline.gui.document.GhostDesk;
import faultline.gui.document.RunDesk;
import faultline.gui.document.Task;
import faultline.gui.edit.EditDesk;
import faultline.gui.export.ExportDesk;
import faultline.gui.text.Language;
import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.Box;
import javax.swing.CellRendererPane;
import javax.swing.DefaultBoundedRangeModel;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JScrollBar;
import javax.swing.JSlider;
import javax.swing.JSpinner;
import javax.swing.JTextField;
import javax.swing.JViewport;
import javax.swing.MenuElement;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

/** All of the window but its frame, without a display. */
class WorkAreaTest {

    /** So many frames the canvas may take until all is painted, on a machine that is slow. */
    private static final int MOST_FRAMES = 20;
    private static final Session.Status PAUSED = new Session.Status(false, 1, 0, 0, Optional.empty(), Optional.empty());
    private static final Session.Status FAST = new Session.Status(true, 100, 12345.67, 0, Optional.empty(), Optional.empty());

    private static final int LEAST_SLIDER = 60;

    private UiActions actions = new UiActions();
    private SimulationCanvas canvas;
    private WorkArea area;
    private JMenuBar menus;

    @BeforeEach
    void build() {
        edt(() -> {
            Theme.LIGHT.install();
            DefaultBoundedRangeModel speed = new DefaultBoundedRangeModel(SpeedScale.REAL_TIME, 0, 0, SpeedScale.MOST);
            Bench bench = new Bench(new Deaf());
            RunDesk run = new RunDesk(bench);
            EditDesk edits = new EditDesk(run::send, () -> {
            });
            canvas = new SimulationCanvas(edits);
            FileDesk files = new FileDesk(canvas, bench, () -> false);
            files.addTo(actions, () -> {
            });
            new EditActions(edits).addTo(actions);
            new ObstacleActions(canvas.tools(), edits, sentence -> {
            }, now -> OptionalDouble.empty(), WindowMemory.none()).addTo(actions);
            new SensorActions(bench, run, edits).addTo(actions);
            new ExportDesk(canvas, bench, canvas, files::fileFor, file -> { }).actions().forEach(actions::add);
            actions.add(UiAction.of("examples", () -> {
            }));
            ViewActions.addTo(actions, canvas);
            actions.add(UiAction.toggle("dark", false, on -> {
            }));
            new RunActions(run, speed).addTo(actions, sensor -> {
            });
            new Dialogs(null).addTo(actions);
            actions.add(UiAction.toggle("instruments", true, shown -> {
            }));
            new ChoiceActions(null, WindowMemory.none()).addTo(actions);
            area = new WorkArea(canvas, edits, actions, speed, tick -> {
            });
            new GhostActions(new GhostDesk(bench, run.travel()), area).addTo(actions, Optional::empty);
            menus = Menus.of(actions);
            area.show(SampleFrames.everything(), PAUSED);
        });
    }

    private static Stream<Arguments> rooms() {
        return Stream.of(new Dimension(1360, 800), new Dimension(1024, 550)).flatMap(room -> Stream.of(TextSize.values())
                .flatMap(size -> Stream.of(Language.values()).map(language -> Arguments.of(room.width, room.height, size, language))));
    }

    @ParameterizedTest
    @MethodSource("rooms")
    void nothingIsCutOffAtTheUsualAndAtTheLeastSizeInAnyLanguageAndSizeOfTexts(int width, int height, TextSize size, Language language) {
        try {
            build(size, language);
            edt(() -> area.status().showNote("A sentence that says why something has been refused."));
            edt(() -> lay(width, height));
            assertEquals(List.of(), onEdt(() -> Components.tree(area).filter(WorkAreaTest::mustBeWhole).filter(part -> !fits(part))
                    .map(WorkAreaTest::describe).toList()));
            assertEquals(1, area.instruments().getTabRunCount(), "rows of tabs");
        } finally {
            build(TextSize.NORMAL, Language.ENGLISH);
        }
    }

    private void build(TextSize size, Language language) {
        edt(size::install);
        Texts.speak(language);
        actions = new UiActions();
        build();
    }

    @Test
    void nothingMovesWhenNumbersChange() {
        edt(() -> lay(1360, 840));
        Map<Component, Rectangle> before = onEdt(this::places);
        Frame frame = SampleFrames.everything();
        edt(() -> {
            area.show(frame, FAST);
            lay(1360, 840);
        });
        assertEquals(before, onEdt(this::places));
    }

    @Test
    void everythingThatCanBeUsedHasANameForReadersOfTheScreen() {
        List<String> nameless = onEdt(() -> Components.tree(area).filter(WorkAreaTest::isUsed).filter(part -> Components.name(part).isBlank())
                .map(WorkAreaTest::describe).toList());
        assertEquals(List.of(), nameless);
        assertTrue(onEdt(() -> Components.tree(area).filter(WorkAreaTest::isUsed).count()) > 40);
    }

    @ParameterizedTest
    @EnumSource(Language.class)
    void everyMenuHasMnemonicsAndNoneTwice(Language language) {
        Texts.speak(language);
        actions = new UiActions();
        build();
        Texts.speak(Language.ENGLISH);
        List<JMenu> all = onEdt(() -> Components.all(menus, JMenu.class).toList());
        assertTrue(all.size() > 5);
        assertDistinct(all.stream().filter(menu -> menu.getParent() == menus).map(menu -> (AbstractButton) menu).toList());
        all.forEach(menu -> assertDistinct(Components.all(menu, AbstractButton.class).filter(item -> item != menu)
                .filter(item -> !(item.getParent() instanceof MenuElement popup) || popup == menu.getPopupMenu()).toList()));
    }

    @Test
    void noTwoActionsHaveTheSameKey() {
        List<String> strokes = actions.all().stream().flatMap(action -> action.stroke().stream()).map(Object::toString).toList();
        assertEquals(strokes.stream().distinct().toList(), strokes);
        assertTrue(strokes.size() > 20);
    }

    @Test
    void theArrowOfAChoiceIsNoStopForTheTabKey() {
        List<AbstractButton> arrows = onEdt(() -> Components.all(area, AbstractButton.class)
                .filter(button -> button.getParent() instanceof JComboBox).toList());
        assertTrue(arrows.size() >= 3);
        assertTrue(arrows.stream().noneMatch(AbstractButton::isFocusable));
    }

    @Test
    void theTipOfAToolNamesItsKey() {
        assertEquals("Make one tick and hold (.)",
                onEdt(() -> Components.named(area, AbstractButton.class, "Step").getToolTipText()));
    }

    @Test
    void theWholePaintsInBothThemes() {
        for (Theme theme : Theme.values()) {
            edt(theme::install);
            build(theme);
            BufferedImage image = onEdt(this::picture);
            long ground = IntStream.range(55, 95).filter(x -> image.getRGB(x, 400) == theme.palette().canvas().getRGB()).count();
            assertTrue(ground > 20, "between the lines of the grid is the canvas' ground");
            assertEquals(theme.colours().background().getRGB(), image.getRGB(1355, 835));
        }
        edt(Theme.LIGHT::install);
    }

    private void build(Theme theme) {
        edt(() -> {
            SwingUtilities.updateComponentTreeUI(area);
            canvas.setPalette(theme.palette());
        });
    }

    private BufferedImage picture() {
        lay(1360, 840);
        BufferedImage image = new BufferedImage(1360, 840, BufferedImage.TYPE_INT_RGB);
        Graphics2D graphics = image.createGraphics();
        IntStream.range(0, MOST_FRAMES).forEach(frame -> area.paint(graphics));
        graphics.dispose();
        return image;
    }

    private void lay(int width, int height) {
        area.setSize(width, height);
        area.setPanelWidth(area.panel().usualWidth());
        // The second pass places the dividers, the third gives a scroll pane what its bars left.
        layout(area);
        layout(area);
        layout(area);
    }

    private static void layout(Container container) {
        container.doLayout();
        for (Component component : container.getComponents()) {
            if (component instanceof Container inner) {
                layout(inner);
            }
        }
    }

    private Map<Component, Rectangle> places() {
        Map<Component, Rectangle> places = new HashMap<>();
        Components.tree(area).forEach(part -> places.put(part, part.getBounds()));
        return places;
    }

    private static boolean mustBeWhole(Component part) {
        boolean text = part instanceof JLabel label && !label.getText().isBlank() && !(label.getParent() instanceof CellRendererPane);
        return (text || part instanceof AbstractButton || part instanceof JSpinner || part instanceof JSlider) && part.isVisible()
                && part.getPreferredSize().width > 0 && !(part.getParent() instanceof Box.Filler);
    }

    /** Whether a part has the room that it wants, and lies within its parent; what scrolls may be higher than what shows. */
    private static boolean fits(Component part) {
        Component parent = part.getParent();
        int wanted = part instanceof JSlider ? LEAST_SLIDER : part.getPreferredSize().width;
        boolean roomy = part.getWidth() >= wanted || part instanceof JSpinner || parent instanceof JSpinner;
        boolean inside = parent instanceof JViewport || part.getX() >= 0 && part.getX() + part.getWidth() <= parent.getWidth()
                && part.getY() >= 0 && part.getY() + part.getHeight() <= parent.getHeight();
        return roomy && inside;
    }

    private static boolean isUsed(Component part) {
        boolean arrow = part.getParent() instanceof JScrollBar || part.getParent() instanceof JComboBox;
        return !arrow && (part instanceof AbstractButton || part instanceof JSpinner || part instanceof JSlider || part instanceof JTextField
                || part instanceof SimulationCanvas || part instanceof JComboBox);
    }

    private static void assertDistinct(List<AbstractButton> items) {
        List<Integer> mnemonics = items.stream().map(AbstractButton::getMnemonic).toList();
        assertTrue(mnemonics.stream().allMatch(mnemonic -> mnemonic > 0), () -> items.stream().map(AbstractButton::getText).toList().toString());
        assertEquals(mnemonics.stream().distinct().toList(), mnemonics, () -> items.stream().map(AbstractButton::getText).toList().toString());
    }

    private static String describe(Component part) {
        String text = part instanceof JLabel label ? label.getText() : part instanceof AbstractButton button ? button.getText() : "";
        return part.getClass().getSimpleName() + " \"" + text + "\" " + Components.name(part) + " " + part.getBounds() + " wants "
                + part.getPreferredSize().width + " in " + part.getParent().getClass().getSimpleName();
    }

    /** Nothing is opened here. */
    private static final class Deaf implements BenchListener {
        @Override
        public void begun() {
            throw new AssertionError();
        }

        @Override
        public void renamed() {
            throw new AssertionError();
        }

        @Override
        public void failed(Task what, Path file, Throwable why) {
            throw new AssertionError(why);
        }
    }
}
