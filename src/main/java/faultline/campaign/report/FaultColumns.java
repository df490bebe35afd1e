package faultline.campaign.report;

import faultline.campaign.plan.CampaignPlan.FactorSummary;
import faultline.campaign.plan.Column;
import java.util.List;

/**
 * The columns of one element of faults in a plan.
 *
 * @param kind the column of the kinds of the faults
 * @param fault the column that names the faults: their labels if the plan has any, their kinds if not
 * @param sensor the column of the sensors that fail
 * @param motor the column of the sides whose motors fail
 * @param all the names of all columns of the element
 */
record FaultColumns(String kind, String fault, String sensor, String motor, List<String> all) {

    static FaultColumns of(FactorSummary faults) {
        List<String> names = faults.columns().stream().map(Column::name).toList();
        String kind = names.get(0);
        String fault = names.stream()
                .filter(name -> name.endsWith("_label"))
                .findFirst()
                .orElse(kind);
        return new FaultColumns(kind, fault, names.get(1), kind.replaceAll("kind$", "") + "motor", names);
    }

    /** Returns what fails in a run: a sensor, or the motors of a side; empty if nothing does. */
    String failingPart(RunRow row) {
        String side = row.text(motor);
        return side.isEmpty() ? row.text(sensor) : side + " motors";
    }

    boolean isFailing(RunRow row) {
        return !failingPart(row).isEmpty();
    }
}
