package faultline.gui.edit;

import faultline.gui.change.Rename;
import faultline.gui.document.Workspace;
import faultline.gui.text.Messages;
import faultline.scenario.xml.AttributeReader;
import faultline.world.Obstacle;
import faultline.world.WorldSpec;
import java.util.HashSet;
import java.util.Optional;
import java.util.Set;

/**
 * Renames obstacles of the scenario, with undo. The run is simulated again with the new id. Event dispatch thread only.
 */
public final class ObstacleEditor {

    private final Workspace workspace;
    private final ScenarioEditor editor;

    public ObstacleEditor(Workspace workspace, ScenarioEditor editor) {
        this.workspace = workspace;
        this.editor = editor;
    }

    /** Returns the id of an obstacle in the edited scenario, which the frames have after its simulation. */
    public String editedId(Obstacle shown) {
        return workspace.ofViews(shown.id());
    }

    /**
     * Gives an obstacle of the edited scenario another id, in the world and in all commands about it. Returns why the
     * id is refused, a sentence in the current language; empty if it is not.
     */
    public Optional<String> rename(String id, String newId) {
        Set<String> ids = takenIds();
        if (newId.equals(id) || !ids.contains(id)) {
            return Optional.empty();
        }
        if (!AttributeReader.isId(newId)) {
            return Optional.of(Messages.get("id.invalid"));
        }
        if (newId.equals(WorldSpec.ENCLOSURE)) {
            return Optional.of(Messages.get("refused.enclosure", newId));
        }
        if (ids.contains(newId)) {
            return Optional.of(Messages.get("obstacle.id.taken", newId));
        }
        editor.rename(Rename.ofObstacle(id, newId));
        return Optional.empty();
    }

    /** Returns the ids of the scenario at any time, and those of the run, which a moved one has before a removal. */
    private Set<String> takenIds() {
        Set<String> ids = new HashSet<>(workspace.obstacleIds());
        workspace.session().ifPresent(session -> session.frame().snapshot().obstacles().stream()
                .map(this::editedId)
                .forEach(ids::add));
        return ids;
    }
}
