package faultline.gui.action;

import faultline.gui.theme.Antialiasing;
import faultline.gui.theme.TextSize;
import faultline.gui.theme.Theme;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.GraphicsConfiguration;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.BoxLayout;
import javax.swing.JComponent;
import javax.swing.JMenuBar;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import javax.swing.Timer;
import javax.swing.event.ChangeListener;
import javax.swing.event.PopupMenuEvent;
import javax.swing.event.PopupMenuListener;
import javax.swing.plaf.basic.DefaultMenuLayout;

/**
 * Lays out the items of a menu. A menu that is higher than the screen shows some of its items between two arrows: it
 * scrolls to the selected item, with the mouse wheel and while the mouse is on an arrow.
 */
public final class ScrolledMenuLayout implements LayoutManager {

    private static final int ARROW_HEIGHT = 14;
    private static final int SCROLL_MILLIS = 90;

    private final JPopupMenu popup;
    private final MenuArrow up = new MenuArrow(-1);
    private final MenuArrow down = new MenuArrow(1);
    /** The index of the uppermost item that shows. */
    private int first;

    private ScrolledMenuLayout(JPopupMenu popup) {
        this.popup = popup;
    }

    /** Lets a menu scroll if it is too high. */
    public static void install(JPopupMenu menu) {
        ScrolledMenuLayout layout = new ScrolledMenuLayout(menu);
        layout.popup.setLayout(layout);
        layout.popup.addPopupMenuListener(layout.new SelectionScroller());
        layout.popup.addMouseWheelListener(event -> layout.scroll(event.getWheelRotation()));
    }

    private List<Component> items() {
        return Stream.of(popup.getComponents())
                .filter(part -> part.isVisible() && !(part instanceof MenuArrow))
                .toList();
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        // It also prepares the columns of the items, which are as wide as the widest.
        Dimension all = new DefaultMenuLayout(popup, BoxLayout.PAGE_AXIS).preferredLayoutSize(popup);
        Insets insets = popup.getInsets();
        return new Dimension(all.width, Math.min(heightOf(items()) + insets.top + insets.bottom, room()));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return preferredLayoutSize(parent);
    }

    @Override
    public void addLayoutComponent(String name, Component item) {
        // All items are components of the menu.
    }

    @Override
    public void removeLayoutComponent(Component item) {
        // All items are components of the menu.
    }

    /** Returns the room on the screen for the menu, below the menu bar if it has a menu there, pixels. */
    private int room() {
        Component menu = popup.getInvoker();
        GraphicsConfiguration device = menu == null ? null : menu.getGraphicsConfiguration();
        if (device == null || !menu.isShowing()) {
            return Integer.MAX_VALUE;
        }
        Rectangle screen = device.getBounds();
        int bottom = screen.y + screen.height - Toolkit.getDefaultToolkit().getScreenInsets(device).bottom;
        return menu.getParent() instanceof JMenuBar
                ? Math.max(bottom - menu.getLocationOnScreen().y - menu.getHeight(), screen.height / 2)
                : screen.height;
    }

    @Override
    public void layoutContainer(Container parent) {
        Insets insets = popup.getInsets();
        int width = popup.getWidth() - insets.left - insets.right;
        List<Component> items = items();
        int bottom = popup.getHeight() - insets.bottom;
        int arrow = isScrolled(popup.getHeight()) ? TextSize.scaled(ARROW_HEIGHT) : 0;
        up.setBounds(insets.left, insets.top, width, arrow);
        down.setBounds(insets.left, bottom - arrow, width, arrow);
        int room = bottom - insets.top - 2 * arrow;
        first = Math.min(first, lastFirst(items, room));
        int end = endOfShown(items, room);
        int y = insets.top + arrow;
        for (int i = 0; i < items.size(); i++) {
            int height = items.get(i).getPreferredSize().height;
            boolean shows = i >= first && i < end;
            // The other items are below the menu.
            items.get(i).setBounds(insets.left, shows ? y : popup.getHeight(), width, height);
            y += shows ? height : 0;
        }
        up.setEnabled(first > 0);
        down.setEnabled(end < items.size());
    }

    /** Returns the index after the last item for which there is room. */
    private int endOfShown(List<Component> items, int room) {
        int end = first;
        while (end < items.size() && heightOf(items.subList(first, end + 1)) <= room) {
            end++;
        }
        return end;
    }

    /** Returns whether a menu of a height cannot show all items. */
    private boolean isScrolled(int height) {
        Insets insets = popup.getInsets();
        return heightOf(items()) > height - insets.top - insets.bottom;
    }

    private static int heightOf(List<Component> items) {
        return items.stream().mapToInt(item -> item.getPreferredSize().height).sum();
    }

    /** Returns the index of the uppermost item when the menu is scrolled to its end. */
    private static int lastFirst(List<Component> items, int room) {
        int index = items.size();
        while (index > 0 && heightOf(items.subList(index - 1, items.size())) <= room) {
            index--;
        }
        return index;
    }

    private void scroll(int steps) {
        first = Math.max(0, first + steps);
        layoutContainer(popup);
        popup.repaint();
    }

    private void show(Component item) {
        int index = items().indexOf(item);
        if (index >= 0 && index < first) {
            scroll(index - first);
        }
        int before = -1;
        while (index >= 0 && item.getY() >= popup.getHeight() && before != first) {
            before = first;
            scroll(1);
        }
    }

    /** Follows the selection while the menu is open. */
    private final class SelectionScroller implements PopupMenuListener {

        private final ChangeListener selection = event -> {
            for (MenuElement element : MenuSelectionManager.defaultManager().getSelectedPath()) {
                show(element.getComponent());
            }
        };

        @Override
        public void popupMenuWillBecomeVisible(PopupMenuEvent event) {
            first = 0;
            if (isScrolled(popup.getPreferredSize().height)) {
                popup.add(up);
                popup.add(down);
            }
            MenuSelectionManager.defaultManager().addChangeListener(selection);
        }

        @Override
        public void popupMenuWillBecomeInvisible(PopupMenuEvent event) {
            MenuSelectionManager.defaultManager().removeChangeListener(selection);
            up.stop();
            down.stop();
            popup.remove(up);
            popup.remove(down);
        }

        @Override
        public void popupMenuCanceled(PopupMenuEvent event) {
            // The menu becomes invisible as well.
        }
    }

    /** An arrow that scrolls the menu while the mouse is on it. */
    private final class MenuArrow extends JComponent {

        private final int direction;
        private final Timer timer;

        MenuArrow(int direction) {
            this.direction = direction;
            timer = new Timer(SCROLL_MILLIS, event -> scroll(direction));
            addMouseListener(new MouseAdapter() {
                @Override
                public void mouseEntered(MouseEvent event) {
                    timer.start();
                }

                @Override
                public void mouseExited(MouseEvent event) {
                    stop();
                }
            });
        }

        void stop() {
            timer.stop();
        }

        @Override
        protected void paintComponent(Graphics graphics) {
            Antialiasing.paint(graphics, g -> {
                g.setColor(
                        isEnabled()
                                ? Theme.current().palette().text()
                                : Theme.current().palette().grid());
                double x = getWidth() / 2.0;
                double y = getHeight() / 2.0;
                Path2D triangle = new Path2D.Double();
                triangle.moveTo(x - 5, y - 2.5 * direction);
                triangle.lineTo(x + 5, y - 2.5 * direction);
                triangle.lineTo(x, y + 2.5 * direction);
                triangle.closePath();
                g.fill(triangle);
            });
        }
    }
}
