package faultline.gui.properties;

import faultline.gui.action.ActionRegistry;
import faultline.gui.action.Keystrokes;
import faultline.gui.action.UiAction;
import faultline.gui.document.Workspace;
import faultline.gui.edit.ScenarioEditor;
import faultline.gui.form.FormConstraints;
import faultline.gui.form.FormDialog;
import faultline.gui.form.NamedChoice;
import faultline.gui.text.Messages;
import faultline.scenario.Scenario;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GridBagLayout;
import java.awt.event.KeyEvent;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.JComponent;
import javax.swing.JPanel;

/** The actions that start a new scenario and change the properties of the open one. */
public final class ScenarioActions {

    private final Component parent;
    private final Workspace workspace;
    private final ScenarioEditor editor;
    private final Consumer<Runnable> afterChanges;
    private final Consumer<Scenario> onNew;

    /**
     * Creates the actions. The editor receives changes of the open scenario. {@code afterChanges} runs an action that
     * would lose unsaved changes, after asking for them, and {@code onNew} receives new scenarios, for which it asks
     * nothing.
     */
    public ScenarioActions(
            Component parent,
            Workspace workspace,
            ScenarioEditor editor,
            Consumer<Runnable> afterChanges,
            Consumer<Scenario> onNew) {
        this.parent = parent;
        this.workspace = workspace;
        this.editor = editor;
        this.afterChanges = afterChanges;
        this.onNew = onNew;
    }

    public void addTo(ActionRegistry actions) {
        actions.add(UiAction.of("new", () -> afterChanges.accept(this::showNewDialog))
                .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_N)));
        actions.add(UiAction.of("properties", this::showPropertiesDialog)
                .withAccelerator(Keystrokes.menuShortcut(KeyEvent.VK_I)));
    }

    private void showNewDialog() {
        PropertiesForm form = new PropertiesForm();
        NamedChoice<ScenarioTemplate> template = new NamedChoice<>(
                ScenarioTemplate.values(),
                value -> Messages.get("template." + value.name()),
                value -> form.setScenario(value.create()));
        form.setScenario(ScenarioTemplate.EMPTY_ROOM.create());
        template.getAccessibleContext().setAccessibleName(Messages.get("template"));
        JPanel choice = new JPanel(new GridBagLayout());
        choice.add(FormConstraints.label("template", template), FormConstraints.cell(0, 0));
        choice.add(template, FormConstraints.fillCell(1, 0));
        JPanel content = new JPanel(new BorderLayout());
        content.add(choice, BorderLayout.NORTH);
        content.add(form, BorderLayout.CENTER);
        if (confirm(content, template, "new.title", () -> form.findProblem(scenarioOf(template)))) {
            onNew.accept(form.properties().applyTo(scenarioOf(template)));
        }
    }

    private static Scenario scenarioOf(NamedChoice<ScenarioTemplate> template) {
        return template.value().create();
    }

    private void showPropertiesDialog() {
        workspace.scenario().ifPresent(open -> {
            ScenarioProperties before = ScenarioProperties.of(open);
            PropertiesForm form = new PropertiesForm();
            form.setScenario(open);
            if (confirm(form, form.nameField(), "properties.title", () -> form.findProblem(open))
                    && !form.properties().equals(before)) {
                edit(editor, before, form.properties());
            }
        });
    }

    /** Changes the properties of the open scenario, as an edit of its own. */
    static void edit(ScenarioEditor editor, ScenarioProperties before, ScenarioProperties after) {
        editor.edit(
                () -> Messages.get("edit.properties"),
                after,
                open -> after.applyChanges(before, open),
                open -> before.applyChanges(after, open));
    }

    /** Shows a form until it is cancelled or nothing is wrong with it, and returns whether it was accepted. */
    private boolean confirm(
            JComponent content, JComponent first, String titleKey, Supplier<Optional<FormDialog.FormProblem>> check) {
        return FormDialog.showDialog(parent, Messages.get(titleKey), content, first, check);
    }
}
