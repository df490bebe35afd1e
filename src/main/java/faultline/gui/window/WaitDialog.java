package faultline.gui.window;

import faultline.gui.document.UnderWay;
import faultline.gui.text.Texts;
import faultline.gui.theme.TextSize;
import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.FlowLayout;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.OptionalDouble;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import javax.swing.KeyStroke;

/** Shows how far something slow has come; its button, Esc and the closing of the dialog give it up. */
final class WaitDialog extends JDialog {

    private static final int PARTS = 1000;
    private static final int WIDTH = 380;

    private final JProgressBar bar = new JProgressBar(0, PARTS);
    private final transient Runnable cancel;

    WaitDialog(Window owner, UnderWay way, Runnable cancel) {
        super(owner, Texts.text("wait.title"), ModalityType.APPLICATION_MODAL);
        this.cancel = cancel;
        setDefaultCloseOperation(DO_NOTHING_ON_CLOSE);
        addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent event) {
                cancel.run();
            }
        });
        String sentence = Texts.text("wait." + way.task(), String.valueOf(way.name().getFileName()));
        bar.getAccessibleContext().setAccessibleName(sentence);
        JPanel content = new JPanel(new BorderLayout(0, 12));
        content.setBorder(BorderFactory.createEmptyBorder(16, 16, 12, 16));
        content.add(new JLabel(sentence), BorderLayout.NORTH);
        content.add(bar, BorderLayout.CENTER);
        content.add(buttons(), BorderLayout.SOUTH);
        setContentPane(content);
        show(way.share());
        pack();
        setSize(new Dimension(Math.max(TextSize.scaled(WIDTH), getWidth()), getHeight()));
        setResizable(false);
        setLocationRelativeTo(owner);
    }

    private JPanel buttons() {
        JButton button = new JButton(Texts.text("wait.cancel"));
        button.addActionListener(event -> cancel.run());
        getRootPane().setDefaultButton(button);
        getRootPane().registerKeyboardAction(event -> cancel.run(), KeyStroke.getKeyStroke("ESCAPE"), JComponent.WHEN_IN_FOCUSED_WINDOW);
        JPanel buttons = new JPanel(new FlowLayout(FlowLayout.TRAILING, 0, 0));
        buttons.add(button);
        return buttons;
    }

    /** Shows how far it has come. */
    void show(OptionalDouble share) {
        bar.setIndeterminate(share.isEmpty());
        share.ifPresent(known -> bar.setValue((int) (PARTS * known)));
    }
}
