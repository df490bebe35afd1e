package faultline.gui.action;

import static faultline.gui.GuiRobot.callOnEdt;
import static faultline.gui.GuiRobot.runOnEdt;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import faultline.gui.EdtChecker;
import faultline.gui.GuiRobot;
import faultline.gui.theme.Theme;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledIf;
import org.junit.jupiter.api.extension.ExtendWith;

/** A menu that is higher than the screen, as the View menu with large text is on small screens. */
@ExtendWith(EdtChecker.class)
@DisabledIf(
        value = "java.awt.GraphicsEnvironment#isHeadless",
        disabledReason = "drives a real window, which needs a display")
class ScrolledMenuRobotTest {

    private static final int COUNT = 100;

    private final GuiRobot robot = new GuiRobot();
    private final AtomicInteger chosen = new AtomicInteger(-1);
    private List<JMenuItem> items;
    private JMenu menu;
    private JFrame frame;

    @BeforeEach
    void open() {
        runOnEdt(() -> {
            Theme.LIGHT.install();
            menu = new JMenu("Many");
            menu.setMnemonic('M');
            ScrolledMenuLayout.install(menu.getPopupMenu());
            items = IntStream.range(0, COUNT).mapToObj(this::createItem).toList();
            items.forEach(menu::add);
            JMenuBar bar = new JMenuBar();
            bar.add(menu);
            frame = new JFrame("Menu");
            frame.setJMenuBar(bar);
            frame.setBounds(60, 40, 300, 200);
        });
        robot.open(frame);
        robot.waitFor("the window has the focus", frame::isFocused);
        robot.pressKeys(KeyEvent.VK_ALT, KeyEvent.VK_M);
        robot.waitFor("the menu shows", () -> menu.isPopupMenuVisible() && isVisible(0));
    }

    @AfterEach
    void close() {
        runOnEdt(frame::dispose);
    }

    private JMenuItem createItem(int number) {
        JMenuItem item = new JMenuItem("Item " + number);
        item.addActionListener(event -> chosen.set(number));
        return item;
    }

    private boolean isVisible(int item) {
        Rectangle shown = items.get(item).getVisibleRect();
        return shown.height > 0 && shown.height == items.get(item).getHeight();
    }

    @Test
    void theMenuIsOnTheScreenAndItsKeysReachItsLastItemAndItsFirst() {
        Rectangle screen = callOnEdt(
                () -> GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds());
        assertTrue(callOnEdt(() -> screen.contains(new Rectangle(
                menu.getPopupMenu().getLocationOnScreen(), menu.getPopupMenu().getSize()))));
        assertTrue(callOnEdt(() -> !isVisible(COUNT - 1)));
        // Opening by the mnemonic selects the first item, from which Up goes to the last one.
        robot.pressKeys(KeyEvent.VK_UP);
        robot.waitFor("the last item shows", () -> isVisible(COUNT - 1) && !isVisible(0));
        robot.pressKeys(KeyEvent.VK_DOWN);
        robot.waitFor("the first item shows again", () -> isVisible(0) && !isVisible(COUNT - 1));
        robot.pressKeys(KeyEvent.VK_UP);
        robot.waitFor("the last item shows", () -> isVisible(COUNT - 1));
        robot.pressKeys(KeyEvent.VK_UP);
        robot.pressKeys(KeyEvent.VK_ENTER);
        robot.waitFor("the item is chosen", () -> chosen.get() == COUNT - 2);
        assertEquals(COUNT, callOnEdt(menu::getItemCount), "the arrows are gone");
    }

    @Test
    void aMenuThatIsTooHighOnlyByItsBorderHasArrows() {
        JPopupMenu popup = callOnEdt(() -> {
            JPopupMenu high = new JPopupMenu();
            ScrolledMenuLayout.install(high);
            int screen = frame.getGraphicsConfiguration().getBounds().height;
            List.of(screen - 101, 50, 50)
                    .forEach(height -> high.add(createItem(0)).setPreferredSize(new Dimension(100, height)));
            assertTrue(high.getInsets().top + high.getInsets().bottom > 1);
            high.show(frame, 0, 0);
            return high;
        });
        robot.waitFor("the menu shows", popup::isShowing);
        // The third item does not fit; the component after the items is the lower arrow.
        assertEquals(5, callOnEdt(popup::getComponentCount));
        assertTrue(callOnEdt(() -> !popup.getComponent(2).getBounds().intersects(new Rectangle(popup.getSize()))));
        assertTrue(callOnEdt(() -> popup.getComponent(4).getHeight()) > 0);
        assertTrue(callOnEdt(() -> popup.getComponent(4).isShowing()));
        runOnEdt(() -> popup.setVisible(false));
    }
}
