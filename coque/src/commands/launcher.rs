//! How many processes a launcher started together, by what it leaves in the environment of each.

/// What a launcher says.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Launched {
    /// Processes.
    pub count: usize,
    /// Which of them this one is, from zero, if that is said.
    pub rank: Option<usize>,
    /// The variable that says how many.
    pub variable: &'static str,
}

/// Variables in which launchers say how many processes they started, and which one it is: Open MPI; MPICH, Intel MPI and Cray, by PMI; MVAPICH; Slurm's `srun`,
/// which comes last, because other launchers may have been started by it.
const VARIABLES: [[&str; 2]; 4] = [
    ["OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"],
    ["PMI_SIZE", "PMI_RANK"],
    ["MV2_COMM_WORLD_SIZE", "MV2_COMM_WORLD_RANK"],
    ["SLURM_STEP_NUM_TASKS", "SLURM_PROCID"],
];

/// What the launcher of this process says; none if it was started by itself.
pub fn launched() -> Option<Launched> {
    said(|variable| std::env::var(variable).ok())
}

fn said(environment: impl Fn(&str) -> Option<String>) -> Option<Launched> {
    let number = |variable| environment(variable)?.trim().parse().ok();
    VARIABLES.into_iter().find_map(|[variable, rank]| {
        let count = number(variable).filter(|&count| count > 0)?;
        Some(Launched { count, rank: number(rank), variable })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_launcher_is_asked_before_the_batch_system() {
        let environment = |variable: &str| match variable {
            "SLURM_STEP_NUM_TASKS" => Some("1".to_owned()),
            "OMPI_COMM_WORLD_SIZE" => Some("4\n".to_owned()),
            "OMPI_COMM_WORLD_RANK" => Some("3".to_owned()),
            _ => None,
        };
        assert_eq!(
            said(environment),
            Some(Launched { count: 4, rank: Some(3), variable: "OMPI_COMM_WORLD_SIZE" })
        );
        assert_eq!(said(|_| None), None);
        assert_eq!(said(|_| Some("many".to_owned())), None);
        assert_eq!(said(|variable| (variable == "PMI_SIZE").then(|| "0".to_owned())), None);
    }
}
