package faultline.gui.gallery;

import faultline.gui.text.ErrorMessages;
import faultline.gui.text.Messages;
import faultline.gui.text.TextListener;
import faultline.gui.theme.DialogButtons;
import faultline.gui.theme.EmptyToolTips;
import faultline.gui.theme.ScreenFit;
import faultline.gui.theme.Theme;
import faultline.gui.theme.UiText;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.FlowLayout;
import java.awt.Point;
import java.awt.Window;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import javax.swing.SwingUtilities;

/**
 * A modal dialog that shows the examples and opens the selected one. Modal, so that a window manager that activates the
 * window behind it gives the keyboard to the dialog, and Space does not start the run behind it.
 */
public final class Gallery extends JDialog {

    private static final int COLUMNS = 3;
    private static final int SEARCH_COLUMNS = 14;
    private static final int HEIGHT = 470;

    private final transient ExampleFilter filter = new ExampleFilter();
    private final JList<Example> list = new JList<>(filter.shown());
    private final JTextField search = new JTextField(SEARCH_COLUMNS);
    private final JTextArea description = UiText.wrappedText();
    private final transient Consumer<String> onOpen;
    private final transient ExampleLoader loader;

    /**
     * Creates a gallery, which fills while it is shown. {@code onOpen} receives the file name of the selected example;
     * {@code onTour} is called after the gallery is closed.
     */
    public Gallery(
            Window owner, Consumer<String> onOpen, boolean atStart, Consumer<Boolean> atStartChanged, Runnable onTour) {
        super(owner, Messages.get("gallery.title"), ModalityType.APPLICATION_MODAL);
        assert EventQueue.isDispatchThread();
        this.onOpen = onOpen;
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        content.add(heading(), BorderLayout.NORTH);
        content.add(scroll(), BorderLayout.CENTER);
        content.add(footer(atStart, atStartChanged, onTour), BorderLayout.SOUTH);
        setContentPane(content);
        EmptyToolTips.disable(content);
        DialogButtons.onClose(this, this::dispose);
        ScreenFit.pack(this);
        setLocationRelativeTo(owner);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowOpened(WindowEvent event) {
                list.requestFocusInWindow();
            }
        });
        description.setText(Messages.get("gallery.loading"));
        loader = new ExampleLoader(Theme.current().palette(), this::add, this::failed);
    }

    private JPanel heading() {
        JComboBox<ExampleGroup> group = new JComboBox<>(ExampleGroup.values());
        group.getAccessibleContext().setAccessibleName(Messages.get("gallery.group"));
        group.addActionListener(event -> {
            filter.setGroup((ExampleGroup) group.getSelectedItem());
            selectFirst();
        });
        search.getAccessibleContext().setAccessibleName(Messages.get("gallery.search"));
        search.getDocument().addDocumentListener(new TextListener(() -> {
            filter.setText(search.getText());
            selectFirst();
        }));
        search.registerKeyboardAction(
                event -> list.requestFocusInWindow(), KeyStroke.getKeyStroke("DOWN"), JComponent.WHEN_FOCUSED);
        JLabel searchLabel = new JLabel(Messages.get("gallery.search"));
        searchLabel.setLabelFor(search);
        JPanel controls = new JPanel(new FlowLayout(FlowLayout.LEADING, 8, 0));
        controls.add(searchLabel);
        controls.add(search);
        controls.add(group);
        JPanel heading = new JPanel(new BorderLayout(0, 8));
        heading.add(UiText.wrappedText(Messages.get("gallery.heading")), BorderLayout.NORTH);
        heading.add(controls, BorderLayout.LINE_START);
        return heading;
    }

    /** Selects the first example, or shows a note if there is none. */
    private void selectFirst() {
        boolean empty = filter.shown().isEmpty();
        list.setSelectedIndex(empty ? -1 : 0);
        list.ensureIndexIsVisible(0);
        if (empty) {
            description.setText(Messages.get("gallery.noMatch"));
        }
    }

    /** Moves a letter or digit that is typed in the list, and the focus, to the search field. */
    private void searchFor(KeyEvent event) {
        boolean shortcut = event.isControlDown() || event.isAltDown() || event.isMetaDown();
        if (Character.isLetterOrDigit(event.getKeyChar()) && !shortcut) {
            search.setText(search.getText() + event.getKeyChar());
            search.requestFocusInWindow();
        }
    }

    private JScrollPane scroll() {
        list.setLayoutOrientation(JList.HORIZONTAL_WRAP);
        list.setVisibleRowCount(0);
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new ExampleCard());
        list.setFixedCellWidth(ExampleCard.SIZE.width);
        list.setFixedCellHeight(ExampleCard.SIZE.height);
        list.addKeyListener(new KeyAdapter() {
            @Override
            public void keyTyped(KeyEvent event) {
                searchFor(event);
            }
        });
        list.getAccessibleContext().setAccessibleName(Messages.get("gallery.title"));
        list.addListSelectionListener(event ->
                description.setText(selectedExample().map(Example::description).orElse("")));
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent event) {
                boolean left = SwingUtilities.isLeftMouseButton(event);
                if (left && event.getClickCount() == 2 && isOnExample(event.getPoint())) {
                    open();
                }
            }
        });
        JScrollPane scroll = new JScrollPane(
                list, ScrollPaneConstants.VERTICAL_SCROLLBAR_ALWAYS, ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.getVerticalScrollBar().setUnitIncrement(ExampleCard.SIZE.height / 4);
        scroll.setPreferredSize(new Dimension(
                COLUMNS * ExampleCard.SIZE.width + scroll.getVerticalScrollBar().getPreferredSize().width + 4, HEIGHT));
        return scroll;
    }

    /** Returns whether a point of the list is on an example, not on the empty place after the last one. */
    private boolean isOnExample(Point at) {
        int nearest = list.locationToIndex(at);
        return nearest >= 0 && list.getCellBounds(nearest, nearest).contains(at);
    }

    private JPanel footer(boolean atStart, Consumer<Boolean> atStartChanged, Runnable onTour) {
        description.setRows(2);
        description.setColumns(20);
        description.getAccessibleContext().setAccessibleName(Messages.get("gallery.description"));
        JCheckBox again = new JCheckBox(Messages.get("gallery.atStart"), atStart);
        again.addActionListener(event -> atStartChanged.accept(again.isSelected()));
        JPanel row = new JPanel(new BorderLayout());
        row.add(again, BorderLayout.LINE_START);
        row.add(buttons(onTour), BorderLayout.LINE_END);
        JPanel foot = new JPanel(new BorderLayout(0, 8));
        foot.add(description, BorderLayout.CENTER);
        foot.add(row, BorderLayout.SOUTH);
        return foot;
    }

    private JPanel buttons(Runnable onTour) {
        JButton tour = new JButton(Messages.get("gallery.tour"));
        tour.addActionListener(event -> {
            dispose();
            onTour.run();
        });
        JButton open = new JButton(Messages.get("gallery.open"));
        open.setEnabled(false);
        open.addActionListener(event -> open());
        list.addListSelectionListener(event -> open.setEnabled(selectedExample().isPresent()));
        JButton close = new JButton(Messages.get("dialog.close"));
        close.addActionListener(event -> dispose());
        getRootPane().setDefaultButton(open);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 8, 0));
        buttons.add(tour);
        buttons.add(open);
        buttons.add(close);
        return buttons;
    }

    private Optional<Example> selectedExample() {
        return Optional.ofNullable(list.getSelectedValue());
    }

    private void open() {
        selectedExample().ifPresent(example -> {
            dispose();
            onOpen.accept(example.file());
        });
    }

    private void add(Example example) {
        filter.add(example);
        if (!filter.shown().isEmpty() && list.isSelectionEmpty()) {
            selectFirst();
        }
    }

    private void failed(Throwable failure) {
        description.setText(Messages.get("gallery.failed", ErrorMessages.describe(failure)));
    }

    @Override
    public void dispose() {
        loader.cancel();
        super.dispose();
    }
}
