// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the stickslip authors

#ifndef stickslip_base_questions_h
#define stickslip_base_questions_h

#include <deal.II/base/mpi.h>

#include <map>
#include <type_traits>

namespace StickSlip
{
  /**
   * Ask other processes: what each of them answers to the question for it,
   * @p answer(question), by their numbers. Questions and answers are anything
   * that some_to_some() sends. Collective.
   */
  template <typename Question, typename Answer>
  auto
  ask(const std::map<unsigned int, Question> &questions,
      const Answer                           &answer,
      const MPI_Comm                         &communicator)
  {
    using dealii::Utilities::MPI::some_to_some;
    std::map<unsigned int, std::decay_t<decltype(answer(Question()))>> answers;
    for (const auto &[process, question] :
         some_to_some(communicator, questions))
      answers.emplace(process, answer(question));
    return some_to_some(communicator, answers);
  }
} // namespace StickSlip

#endif
